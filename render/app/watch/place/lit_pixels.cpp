#include "render/app/watch/place/lit_pixels.h"

#include "render/app/run/run.h"
#include "render/app/run/stage_options.h"
#include "render/explain/ray_spans.h"
#include "render/layers/layers.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>

namespace app {
namespace {

using Milliseconds = std::chrono::duration<double, std::milli>;

constexpr double kLitPatience = 150;           // milliseconds for parts of solids
constexpr std::array kSquares = {8, 4, 2, 1};  // a side, coarse to fine

enum class Held { Nothing, Part, Whole };

/// How much of an object stands in a statement.
Held held_by(const scene::Object& object, std::size_t file, language::Range statement)
{
    const scene::SourceRef& at = object.source;
    if (at.somewhere() && at.file == file && at.offset >= statement.begin && at.offset < statement.end)
        return Held::Whole;
    const auto* csg = std::get_if<scene::Csg>(&object.shape);
    if (csg == nullptr || !csg->operands) return Held::Nothing;
    const bool any = std::any_of(csg->operands->begin(), csg->operands->end(), [&](const scene::Object& operand) {
        return held_by(operand, file, statement) != Held::Nothing;
    });
    return any ? Held::Part : Held::Nothing;
}

/// Tells which part of one object a point of its surface belongs to.
class Parts {
public:
    Parts(const scene::Description& scene, const scene::Object& object) : eye_(scene.camera.location)
    {
        alone_.global = scene.global;
        alone_.effective_version = scene.effective_version;
        alone_.povray = scene.povray;
        alone_.objects.push_back(object);
        spans_ = std::make_unique<explain::RaySpans>(alone_);
    }

    /// Where its text stands; nowhere: none is near.
    scene::SourceRef at(const glm::dvec3& point)
    {
        constexpr double kStep = 1e-3;  // points are in single precision
        const double far = glm::length(point - eye_);
        if (!(far > 0.0) || !std::isfinite(far)) return {};
        const glm::dvec3 direction = (point - eye_) / far;
        const double step = kStep * (1.0 + far);
        const std::vector<explain::ObjectSpans> found = spans_->along({point - step * direction, direction}, 1);
        scene::SourceRef nearest;
        double least = step;
        if (found.empty()) return nearest;
        for (const explain::Piece& piece : found.front().pieces)
            for (const explain::End& end : {piece.in, piece.out})
                if (end.leaf != nullptr && std::abs(end.t - step) < least) {
                    least = std::abs(end.t - step);
                    nearest = end.leaf->source;
                }
        return nearest;
    }

private:
    const glm::dvec3 eye_;
    scene::Description alone_;
    std::unique_ptr<explain::RaySpans> spans_;
};

class Lighting {
public:
    Lighting(const SeenPixels& seen, const scene::Description& scene, std::size_t file, language::Range statement)
        : seen_(seen), scene_(scene), file_(file), statement_(statement)
    {
        for (const scene::Object& object : scene.objects) held_.push_back(held_by(object, file, statement));
    }

    bool any() const
    {
        return std::any_of(held_.begin(), held_.end(), [](Held held) { return held != Held::Nothing; });
    }

    /// As fine as time allows.
    LitPixels pixels()
    {
        LitPixels best;
        bool told = false;
        const bool parts = std::find(held_.begin(), held_.end(), Held::Part) != held_.end();
        for (const int step : kSquares) {
            if (!parts && step > 1) continue;
            LitPixels now;
            if (!light(step, now)) break;
            best = std::move(now);
            told = true;
        }
        if (told) return best;
        for (Held& held : held_)
            if (held == Held::Part) held = Held::Whole;
        light(1, best);
        best.whole = true;
        return best;
    }

private:
    /// False: it takes too long.
    bool light(int step, LitPixels& out)
    {
        out.step = step;
        out.statement = statement_;
        out.width = (seen_.width() + step - 1) / step;
        out.height = (seen_.height() + step - 1) / step;
        bool last = false;
        int run = 0;
        for (int y = 0; y < out.height; ++y)
            for (int x = 0; x < out.width; ++x, ++run) {
                const bool lit = is_lit(std::min(x * step + step / 2, seen_.width() - 1),
                                        std::min(y * step + step / 2, seen_.height() - 1));
                if (Milliseconds(std::chrono::steady_clock::now() - start_).count() > kLitPatience) return false;
                if (lit == last) continue;
                out.runs.push_back(run);
                run = 0;
                last = lit;
            }
        out.runs.push_back(run);
        return true;
    }

    bool is_lit(int x, int y)
    {
        const std::optional<std::size_t> statement = seen_.statement(x, y);
        if (!statement || *statement >= held_.size() || held_[*statement] == Held::Nothing) return false;
        if (held_[*statement] == Held::Whole) return true;
        auto& parts = parts_[*statement];
        if (!parts) parts = std::make_unique<Parts>(scene_, scene_.objects[*statement]);
        const scene::SourceRef at = parts->at(seen_.point(x, y));
        return at.somewhere() && at.file == file_ && at.offset >= statement_.begin && at.offset < statement_.end;
    }

    const SeenPixels& seen_;
    const scene::Description& scene_;
    const std::size_t file_;
    const language::Range statement_;
    std::vector<Held> held_;  ///< by object
    std::map<std::size_t, std::unique_ptr<Parts>> parts_;
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

SeenPixels::SeenPixels(const Settings& settings, const scene::Description& scene, const std::atomic<bool>& cancel)
    : width_(settings.width), height_(settings.height)
{
    const plan::CompiledScene compiled = plan::compile(scene, plan_options(settings));
    trace::RenderOptions options;
    options.threads = threads_of(settings);
    options.isa = isa_of(settings);
    options.cancel = &cancel;
    const std::vector<std::string> names(scene.objects.size());
    const auto channels = layers::make_layers(compiled, {layers::Kind::Position, layers::Kind::Object}, names, options,
                                              false, {0, height_});
    const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    statements_.assign(pixels, 0.0f);
    points_.assign(3 * pixels, 0.0f);
    if (!channels) return;
    constexpr std::size_t kStatementChannel = 3;  // behind the position's three
    const float* from = channels->values.data();
    for (std::size_t i = 0; i < pixels; ++i, from += channels->names.size()) {
        std::copy_n(from, 3, &points_[3 * i]);
        statements_[i] = from[kStatementChannel];
    }
}

std::optional<std::size_t> SeenPixels::statement(int x, int y) const
{
    const float number =
        statements_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
    return number > 0.0f ? std::optional(static_cast<std::size_t>(number) - 1) : std::nullopt;
}

glm::dvec3 SeenPixels::point(int x, int y) const
{
    const float* const p =
        &points_[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x))];
    return {p[0], p[1], p[2]};
}

std::optional<LitPixels> lit_pixels(const SeenPixels& seen, const scene::Description& scene, std::size_t file,
                                    const std::vector<language::Range>& statements)
{
    for (const language::Range statement : statements) {
        Lighting lighting(seen, scene, file, statement);
        if (lighting.any()) return lighting.pixels();
    }
    return {};
}

std::optional<scene::Place> place_seen(const SeenPixels& seen, const scene::Description& scene, int x, int y)
{
    const std::optional<std::size_t> statement = seen.statement(x, y);
    if (!statement || *statement >= scene.objects.size()) return {};
    const scene::Object& object = scene.objects[*statement];
    scene::SourceRef source = object.source;
    if (std::holds_alternative<scene::Csg>(object.shape)) {
        const scene::SourceRef part = Parts(scene, object).at(seen.point(x, y));
        if (part.somewhere()) source = part;
    }
    const scene::Place place = scene.place(source);
    return place.path.empty() ? std::nullopt : std::optional(place);
}

}  // namespace app
