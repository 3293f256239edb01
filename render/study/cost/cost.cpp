#include "render/study/cost/cost.h"

#include "render/study/cost/sampled_run.h"
#include "render/kernel/gather/indirect_light.h"
#include "render/picture/passes/passes.h"
#include "render/scene/base/thread_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace study {
namespace {

constexpr std::size_t kPixels = 1u << 15;  // sampled at most
constexpr double kSeconds = 0.03;          // of a measurement: fewer pixels where they take longer
constexpr int kRounds = 5;                 // of which the middle one counts
constexpr double kShare = 0.01;            // of the whole: half of a scene that costs less is not looked into
constexpr std::size_t kMostLights = 64, kMostTextures = 64;

double middle(std::vector<double> values)
{
    std::nth_element(values.begin(), values.begin() + kRounds / 2, values.end());
    return values[kRounds / 2];
}

class CostRun {
public:
    CostRun(const scene::Description& scene, const plan::Options& options, const trace::RenderOptions& render)
        : scene_(scene), options_(options), render_(render), kernel_(trace::load_kernel(render.isa)),
          whole_(plan::compile(scene, options)), indirect_(trace::run_passes(whole_, render)),
          positions_(scattered_tiles(options, kPixels))
    {
        const double once = seconds(whole_);
        if (once > kSeconds)
            positions_ =
                scattered_tiles(options, static_cast<std::size_t>(static_cast<double>(kPixels) * kSeconds / once));
    }

    Costs run()
    {
        find_whole();
        lights();
        textures();
        left_out();
        std::vector<std::size_t> statements;
        for (std::size_t i = 0; i < scene_.objects.size(); ++i)
            if (!scene::is_light(scene_.objects[i])) statements.push_back(i);
        look_into(statements);
        std::stable_sort(out_.costs.begin(), out_.costs.end(),
                         [](const Cost& a, const Cost& b) { return a.kind != b.kind ? a.kind < b.kind : a.ns > b.ns; });
        return std::move(out_);
    }

private:
    bool cancelled() const { return render_.cancel != nullptr && *render_.cancel; }

    /// Of the sample, with a tracer that has seen some of it.
    double seconds(const plan::CompiledScene& scene)
    {
        const OwnTracer tracer = make_tracer(kernel_, scene, indirect_.get(), render_.cancel);
        colors_.resize(positions_.size());
        const std::size_t warm = std::min<std::size_t>(positions_.size(), 64);
        kernel_.sample(*tracer, {positions_.data(), warm}, colors_.data());
        const double begun = scene::thread_seconds();
        kernel_.sample(*tracer, positions_, colors_.data());
        const double end = scene::thread_seconds();
        const trace::RayCounts counts = kernel_.counts(*tracer);
        rays_ = counts.camera > 0 ? ray_count(counts) / static_cast<double>(counts.camera) : 0.0;
        return end - begun;
    }

    double ns(double time) const { return 1e9 * time / static_cast<double>(positions_.size()); }

    void find_whole()
    {
        std::vector<double> all, apart;
        for (int i = 0; i < kRounds; ++i) {
            const double first = seconds(whole_), second = seconds(whole_);
            all.push_back(first);
            apart.push_back(std::abs(first - second));
        }
        out_.ns = ns(middle(all));
        out_.noise = ns(*std::max_element(apart.begin(), apart.end()));
        out_.rays = rays_;
        out_.sampled = positions_.size();
    }

    /// How many more nanoseconds per position the whole scene takes than `other`, the scene without one thing; both are
    /// timed in turn, kRounds times. 0 where the difference is noise.
    template <class With>
    double more_than(With&& other)
    {
        std::vector<double> more;
        for (int i = 0; i < kRounds && !cancelled(); ++i) {
            const double with = seconds(whole_);
            more.push_back(with - other());
        }
        if (cancelled()) return 0.0;
        const auto above = std::count_if(more.begin(), more.end(), [](double m) { return m > 0.0; });
        return above > 1 && above < kRounds - 1 ? 0.0 : ns(middle(more));  // of either sign: noise
    }

    void add(Cost::Kind kind, std::string what, double cost)
    {
        if (std::abs(cost) <= out_.noise) ++out_.too_small;
        else out_.costs.push_back({kind, std::move(what), cost});
    }

    void lights()
    {
        auto& lights = whole_.lights.lights;
        for (std::size_t i = 0; i < std::min(lights.size(), kMostLights) && !cancelled(); ++i) {
            const double cost = more_than([&] {
                light::Light taken = lights[i];
                lights.erase(lights.begin() + static_cast<std::ptrdiff_t>(i));
                const double time = seconds(whole_);
                lights.insert(lights.begin() + static_cast<std::ptrdiff_t>(i), std::move(taken));
                return time;
            });
            const glm::dvec3& at = lights[i].location;
            add(Cost::Kind::Light, fmt::format("light {} at <{:g}, {:g}, {:g}>", i + 1, at.x, at.y, at.z), cost);
        }
    }

    /// Textures in use, each against plain grey.
    void textures()
    {
        texture::TextureSet& set = whole_.textures;
        texture::Texture plain;
        plain.first = static_cast<std::uint32_t>(set.layers.size());
        plain.count = 1;
        texture::Layer layer;
        layer.pigment = static_cast<std::uint32_t>(set.pigments.size());
        layer.finish = static_cast<std::uint32_t>(set.finishes.size());
        set.pigments.push_back({texture::Pigment::Kind::Solid, {0.5f, 0.5f, 0.5f, 0.0f, 0.0f}});
        set.finishes.emplace_back();
        set.finishes.back().diffuse = 0.6f;
        set.layers.push_back(layer);
        plain.opaque = plain.plain = plain.lit = true;
        std::vector<std::string> places(set.textures.size());
        for (const plan::Surface& surface : whole_.surfaces)
            if (surface.texture != plan::kNone && places[surface.texture].empty())
                places[surface.texture] = place(whole_.objects[surface.object].source);
        std::size_t measured = 0;
        for (std::size_t i = 0; i < set.textures.size() && measured < kMostTextures && !cancelled(); ++i) {
            if (places[i].empty()) continue;
            ++measured;
            const double cost = more_than([&] {
                const texture::Texture taken = std::exchange(set.textures[i], plain);
                const double time = seconds(whole_);
                set.textures[i] = taken;
                return time;
            });
            add(Cost::Kind::Texture, "texture of the object at " + places[i], cost);
        }
    }

    void left_out()
    {
        for (std::size_t i = 0; i < plan::kLeanSteps && !cancelled(); ++i) {
            const auto step = static_cast<plan::LeanStep>(i);
            if (!taken(step)) continue;
            plan::Options options = options_;
            options.lean.switch_off(step);
            const plan::CompiledScene full = plan::compile(scene_, options);
            add(Cost::Kind::LeftOut, std::string(plan::name_of(step)), -more_than([&] { return seconds(full); }));
        }
    }

    /// Whether the step has left something out of this scene; of two that is not known before rays are traced.
    bool taken(plan::LeanStep step) const
    {
        return step == plan::LeanStep::HitDetails || step == plan::LeanStep::Interiors ||
               std::any_of(whole_.decisions.begin(), whole_.decisions.end(),
                           [step](const plan::Decision& made) { return made.step == step; });
    }

    std::string place(const scene::SourceRef& source) const { return scene::place_text(scene_.place(source)); }

    /// Statements, as a group and then by halves.
    void look_into(const std::vector<std::size_t>& group)
    {
        if (group.empty() || cancelled()) return;
        scene::Description rest = scene_;
        rest.objects.clear();
        for (std::size_t i = 0, next = 0; i < scene_.objects.size(); ++i) {
            if (next < group.size() && group[next] == i) ++next;
            else rest.objects.push_back(scene_.objects[i]);
        }
        const plan::CompiledScene without = plan::compile(rest, options_);
        const double cost = more_than([&] { return seconds(without); });
        if (group.size() == 1)
            return add(Cost::Kind::Statement, "statement at " + place(scene_.objects[group[0]].source), cost);
        if (group.size() > kFew && std::abs(cost) <= std::max(out_.noise, kShare * out_.ns)) {
            out_.too_small += group.size();
            return;
        }
        const auto half = group.begin() + static_cast<std::ptrdiff_t>(group.size() / 2);
        look_into({group.begin(), half});
        look_into({half, group.end()});
    }

    static constexpr std::size_t kFew = 32;  // are looked into one by one: one may hide what another costs

    const scene::Description& scene_;
    const plan::Options options_;
    const trace::RenderOptions& render_;
    const trace::KernelTable& kernel_;
    plan::CompiledScene whole_;
    std::shared_ptr<const trace::IndirectLight> indirect_;
    std::vector<trace::SamplePosition> positions_;
    std::vector<scene::Color> colors_;
    double rays_ = 0.0;
    Costs out_;
};

}  // namespace

Costs measure_costs(const scene::Description& scene, const plan::Options& options, const trace::RenderOptions& render)
{
    return CostRun(scene, options, render).run();
}

std::string text_of(const Costs& costs)
{
    std::string out = fmt::format("cost: {:.0f} ns a ray of the camera, {:.2f} rays of all kinds each; {} sampled; "
                                  "differences below {:.0f} ns are "
                                  "noise\n",
                                  costs.ns, costs.rays, costs.sampled, costs.noise);
    for (const Cost& cost : costs.costs) {
        const bool left_out = cost.kind == Cost::Kind::LeftOut;
        out += fmt::format("{} {:.0f} ns ({:.1f} %): {}\n", left_out ? "left out, would cost" : "costs", cost.ns,
                           100.0 * cost.ns / costs.ns, cost.what);
    }
    if (costs.too_small > 0) out += fmt::format("{} more parts cost less than the noise\n", costs.too_small);
    return out;
}

}  // namespace study
