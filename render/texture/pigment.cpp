#include "render/texture/evaluate.h"
#include "render/texture/function_host.h"

#include <algorithm>

namespace texture {

Blend blend_at(const TextureSet& set, std::uint32_t first, std::uint32_t count, double value)
{
    constexpr std::uint32_t kAtOnce = 16;  // maps have up to 256 entries
    const std::uint32_t last = first + count - 1;
    if (value >= static_cast<double>(set.keys[last])) return {last, last, 0.0};
    std::uint32_t i = first;
    const auto all_below = [&](std::uint32_t from) {  // in registers
        std::uint32_t below = 0;
        for (std::uint32_t k = 0; k < kAtOnce; ++k) below += static_cast<double>(set.keys[from + k]) < value ? 1 : 0;
        return below == kAtOnce;
    };
    while (last - i >= kAtOnce && all_below(i)) i += kAtOnce;
    while (static_cast<double>(set.keys[i]) < value) ++i;  // ends: the last key is above; NaN stops at the first
    const auto upper_key = static_cast<double>(set.keys[i]);
    if (i == first || value == upper_key || value != value) return {i, i, 0.0};
    const auto lower_key = static_cast<double>(set.keys[i - 1]);
    return {i - 1, i, (value - lower_key) / (upper_key - lower_key)};
}

scene::Color mix(const scene::Color& lower, const scene::Color& upper, double share)
{
    const auto one = [share](float a, float b) { return a + static_cast<float>(share * static_cast<double>(b - a)); };
    return {one(lower.red, upper.red), one(lower.green, upper.green), one(lower.blue, upper.blue),
            one(lower.filter, upper.filter), one(lower.transmit, upper.transmit)};
}

scene::Color mix(const image::TransferCurve& working, const scene::Blending& blending, const scene::Color& lower,
                 const scene::Color& upper, double share)
{
    using Mode = scene::Blending::Mode;
    if (blending.mode == Mode::Working) return mix(lower, upper, share);
    scene::Color out;
    const auto between = [&](const image::TransferCurve& of, float a, float b) {
        const float from = of.encode(working.decode(a)), to = of.encode(working.decode(b));
        return working.encode(of.decode(from + static_cast<float>(share * static_cast<double>(to - from))));
    };
    const image::TransferCurve light, levels = image::TransferCurve::power(blending.gamma);
    const image::TransferCurve& mixed = blending.mode == Mode::Power ? levels : light;
    out.red = between(mixed, lower.red, upper.red);
    out.green = between(mixed, lower.green, upper.green);
    out.blue = between(mixed, lower.blue, upper.blue);
    out.filter = between(light, lower.filter, upper.filter);
    out.transmit = between(light, lower.transmit, upper.transmit);
    if (blending.mode != Mode::Brightness) return out;
    const float grey = scene::grey(out.rgb()),
                wanted = between(levels, scene::grey(lower.rgb()), scene::grey(upper.rgb()));
    const float scale = grey == 0.0f ? 1.0f : wanted / grey;
    return {scale * out.red, scale * out.green, scale * out.blue, out.filter, out.transmit};
}

void add_weighted(scene::Color& sum, float weight, const scene::Color& c)
{
    sum.red += weight * c.red;
    sum.green += weight * c.green;
    sum.blue += weight * c.blue;
    sum.filter += weight * c.filter;
    sum.transmit += weight * c.transmit;
}

scene::Color mapped(const TextureSet& set, const scene::Blending& blending, const Blend& at)
{
    if (at.lower == at.upper) return set.colors[at.lower];
    return mix(set.working, blending, set.colors[at.lower], set.colors[at.upper], at.share);
}

scene::Color divided(const scene::Color& sum, float weights)
{
    return {sum.red / weights, sum.green / weights, sum.blue / weights, sum.filter / weights, sum.transmit / weights};
}

namespace {

scene::Color average_color(const TextureSet& set, const Pigment& pigment, const glm::dvec3& p,
                           const Surroundings& around)
{
    scene::Color sum;
    float weights = 0;
    for (std::uint32_t i = pigment.first; i < pigment.first + pigment.count; ++i) {
        const scene::Color c = pigment_color(set, set.children[i], p, around);
        const float w = set.keys[i];
        weights += w;
        add_weighted(sum, w, c);
    }
    return divided(sum, weights);
}

scene::Color function_color(const TextureSet& set, const ColorFunctions& functions, const glm::dvec3& p)
{
    const double at[] = {p.x, p.y, p.z};
    const auto part = [&](std::size_t i) {
        if (functions[i] == kNone) return 0.0f;
        return static_cast<float>(function::evaluate(*set.functions[functions[i]], at, FunctionHost(set)));
    };
    return {part(0), part(1), part(2), part(3), part(4)};
}

}  // namespace

scene::Color pigment_color(const TextureSet& set, std::uint32_t index, const glm::dvec3& p, const Surroundings& around)
{
    const Pigment& pigment = set.pigments[index];
    if (pigment.kind == Pigment::Kind::Solid) return pigment.color;
    if (pigment.kind == Pigment::Kind::Uv)
        return pigment_color(set, set.children[pigment.first], {around.uv.x, around.uv.y, 0.0}, around);
    const Pattern& pattern = set.patterns[pigment.pattern];
    const glm::dvec3 q = warp_point(set, pattern, p);
    if (pigment.kind == Pigment::Kind::Image) return image_shown(set.images[pattern.data], q);
    if (pigment.kind == Pigment::Kind::Functions) return function_color(set, set.color_functions[pigment.first], q);
    if (pigment.kind == Pigment::Kind::Average) return average_color(set, pigment, q, around);
    const Blend blend = blend_at(set, pigment.first, pigment.count, pattern_value(set, pattern, q, around));
    if (pigment.kind == Pigment::Kind::ColorMap) return mapped(set, pigment.blending, blend);
    const scene::Color lower = pigment_color(set, set.children[blend.lower], q, around);
    if (blend.lower == blend.upper) return lower;
    const scene::Color upper = pigment_color(set, set.children[blend.upper], q, around);
    return mix(set.working, pigment.blending, lower, upper, blend.share);
}

bool pigment_missing(const TextureSet& set, std::uint32_t index, const glm::dvec3& p, const Surroundings& around)
{
    const Pigment& pigment = set.pigments[index];
    if (pigment.kind == Pigment::Kind::Uv)
        return pigment_missing(set, set.children[pigment.first], {around.uv.x, around.uv.y, 0.0}, around);
    if (pigment.kind != Pigment::Kind::Image) return false;
    const Pattern& pattern = set.patterns[pigment.pattern];
    glm::dvec2 place;
    return !image_place(set.images[pattern.data], warp_point(set, pattern, p), place);
}

std::uint32_t material_at(const TextureSet& set, const Texture& texture, const glm::dvec3& p)
{
    const Image& image = set.images[set.patterns[texture.pattern].data];
    glm::dvec2 place;
    auto index = image_place(image, p, place) ? static_cast<std::uint32_t>(std::max(0, image_index(image, place))) : 0u;
    if (index > texture.count) index %= texture.count;
    return set.children[texture.first + std::min(index, texture.count - 1)];
}

}  // namespace texture
