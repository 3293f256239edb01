#include "render/plan/textures/pattern_kinds.h"

#include <algorithm>
#include <unordered_map>

namespace plan {
namespace {

using texture::PatternKind;

const std::unordered_map<std::string, PatternKind> kKinds{
#define PATTERN(keyword, enumerator, value) {keyword, PatternKind::enumerator},
#include "render/texture/pattern_table.inc"
#undef PATTERN
    {"average", PatternKind::Average},
    {"facets", PatternKind::Facets},
    {"uv_mapping", PatternKind::Uv},
    {"user_defined", PatternKind::UserDefined},
    // Other names of the same.
    {"spotted", PatternKind::Bozo},
    {"image_map", PatternKind::Image},
    {"bump_map", PatternKind::Image},
    {"material_map", PatternKind::Image},
};

/// Through memory on purpose: g++ 12.2's vectoriser drops a pair of double-float-double conversions side by side.
double single(double v)
{
    const volatile float rounded = static_cast<float>(v);
    return static_cast<double>(rounded);
}

scene::Turbulence rounded(scene::Turbulence t)
{
    t.octaves = std::clamp(t.octaves, 1, 10);
    t.lambda = single(t.lambda);
    t.omega = single(t.omega);
    return t;
}

struct CompileWarp {
    std::vector<texture::Warp>& out;
    void operator()(const csg::Transform& t) const
    {
        if (t.identity()) return;
        out.emplace_back(texture::Affine{t.inverse_linear, t.inverse_offset, glm::transpose(t.linear)});
    }
    void operator()(const scene::Turbulence& t) const
    {
        if (t.amount != glm::dvec3(0)) out.emplace_back(rounded(t));
    }
    void operator()(const scene::RepeatWarp& w) const { out.emplace_back(w); }
    void operator()(scene::BlackHoleWarp w) const
    {
        // POV-Ray moves a repeated hole away from the block's faces and widens the block to hold it (spec 4, 8.2).
        for (int k = 0; k < 3; ++k)
            if (w.repeat[k] > 0.0) {
                w.center[k] = std::max(w.center[k], w.radius);
                w.repeat[k] = std::max(w.repeat[k], w.center[k] + w.radius + w.turbulence[k]);
            }
        out.emplace_back(w);
    }
    void operator()(const scene::MappingWarp& w) const { out.emplace_back(w); }
};

/// Parameters by kind, defaults where none is given (docs/patterns.md).
void set_numbers(const scene::Pattern& from, texture::Pattern& to)
{
    const std::size_t count = std::min(from.numbers.size(), to.numbers.size());
    std::copy_n(from.numbers.begin(), count, to.numbers.begin());
    to.vector = from.vector;
    switch (to.kind) {
    case PatternKind::Agate: to.numbers[0] = count > 0 ? single(to.numbers[0]) : 1.0; break;
    case PatternKind::Brick: to.numbers[0] = single((count > 0 ? to.numbers[0] : 0.5) - 2e-10); break;
    case PatternKind::Quilted:
        for (std::size_t i = 0; i < 2; ++i) to.numbers[i] = i < count ? single(to.numbers[i]) : 1.0;
        break;
    case PatternKind::Gradient: {
        const double length = glm::length(to.vector);
        to.vector = length > 0.0 ? to.vector / length : glm::dvec3(1, 0, 0);
        break;
    }
    default: break;
    }
}

/// Values that stand for one of a list each, which POV-Ray 3.8 gives no frequency, phase or wave (spec 7b, 10).
bool stands_for_place(PatternKind kind)
{
    switch (kind) {
    case PatternKind::Brick:
    case PatternKind::Checker:
    case PatternKind::Cubic:
    case PatternKind::Hexagon:
    case PatternKind::Object:
    case PatternKind::Square:
    case PatternKind::Triangular: return true;
    default: return false;
    }
}

}  // namespace

std::optional<texture::PatternKind> pattern_kind(const std::string& keyword)
{
    const auto found = kKinds.find(keyword);
    return found == kKinds.end() ? std::nullopt : std::optional(found->second);
}

void compile_warps(const scene::Pattern& description, const csg::Transform* by, texture::Pattern& out,
                   std::vector<texture::Warp>& warps)
{
    out.first_warp = static_cast<std::uint32_t>(warps.size());
    auto step = description.warps.rbegin();
    const auto end = description.warps.rend();
    if (by != nullptr) {  // as scene::Pattern::transform puts it there
        const auto* last = step != end ? std::get_if<csg::Transform>(&*step) : nullptr;
        CompileWarp{warps}(last != nullptr ? *by * *last : *by);
        if (last != nullptr) ++step;
    }
    for (; step != end; ++step) std::visit(CompileWarp{warps}, *step);
    out.warp_count = static_cast<std::uint32_t>(warps.size()) - out.first_warp;
}

texture::Pattern compile_pattern(const scene::Pattern& description, const csg::Transform* by, texture::PatternKind kind,
                                 int scene_generator, scene::PovRay povray, std::vector<texture::Warp>& warps)
{
    texture::Pattern out;
    out.kind = kind;
    out.noise_generator =
        static_cast<std::uint8_t>(description.noise_generator ? description.noise_generator : scene_generator);
    if (povray == scene::PovRay::V38 && stands_for_place(kind)) {
        out.frequency = 0.0;
    } else {
        out.wave = description.wave;
        out.frequency = single(description.frequency);
        out.phase = single(description.phase);
        out.poly_exponent = single(description.poly_exponent);
    }
    out.folds = out.frequency != 0.0;
    set_numbers(description, out);
    compile_warps(description, by, out, warps);
    if (description.turbulence) {
        out.has_turbulence = true;
        out.turbulence = rounded(*description.turbulence);
        // Before 3.8 these two have it in their formulas alone; since then in both, as spirals (spec 7d, 1).
        const bool inside_alone = povray == scene::PovRay::V37 &&
                                  (kind == PatternKind::Marble || kind == PatternKind::Wood);
        out.displaces = out.turbulence.amount != glm::dvec3(0) && !inside_alone;
    }
    return out;
}

}  // namespace plan
