#include "render/trace/shade/sky.h"

#include "render/texture/evaluate_points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace trace {
namespace {

/// color_of(i) is the colour of layer i.
template <class ColorOf>
scene::Color layered_sky(const texture::Sky& sky, bool see_through, ColorOf&& color_of)
{
    glm::vec3 sum(0), filter(1);
    for (std::size_t i = sky.layers.size(); i-- > 0;) {
        const scene::Color c = color_of(i);
        sum += c.rgb() * (1.0f - c.filter - c.transmit) * filter * sky.emission;
        filter *= c.rgb() * c.filter + c.transmit;
    }
    const scene::Color& b = sky.background;
    const float f = see_through ? b.filter : 0.0f, t = see_through ? b.transmit : 0.0f;
    sum += b.rgb() * (1.0f - f - t) * filter;
    filter *= b.rgb() * f + t;
    scene::Color out = scene::Color::of(sum);
    out.transmit = std::min(1.0f, std::abs(scene::grey(filter)));
    return out;
}

template <class ColorOf>
scene::Color legacy_sky(const texture::Sky& sky, ColorOf&& color_of)
{
    scene::Color sum, filter{1, 1, 1, 1, 1};
    float share = 1;
    for (std::size_t i = sky.layers.size(); i-- > 0;) {
        const scene::Color c = color_of(i);
        const float own = share * (1.0f - c.filter - c.transmit);
        sum.red += c.red * own;
        sum.green += c.green * own;
        sum.blue += c.blue * own;
        filter = {filter.red * c.red, filter.green * c.green, filter.blue * c.blue, filter.filter * c.filter,
                  filter.transmit * c.transmit};
        share = std::abs(filter.filter) + std::abs(filter.transmit);
    }
    return scene::Color::of(sum.rgb() * sky.emission +
                            sky.background.rgb() * (filter.rgb() * filter.filter + filter.transmit));
}

/// What a ray sees of the sky with its layers in these colours.
template <class ColorOf>
scene::Color seen_sky(const texture::Sky& sky, bool mirrored, ColorOf&& color_of)
{
    if (sky.layers.empty()) {
        scene::Color c = sky.background;
        if (mirrored) c.filter = c.transmit = 0.0f;
        return c;
    }
    if (!sky.legacy) return layered_sky(sky, sky.alpha_output && !mirrored, color_of);
    if (sky.alpha_output && !mirrored) return {0, 0, 0, 0, 1};
    return legacy_sky(sky, color_of);
}

scene::Color sky_color(const Context& context, const RayState& state)
{
    const texture::Sky& sky = context.scene.sky;
    const texture::Surroundings around{{}, {}, state.ray.direction};
    return seen_sky(sky, state.kind != plan::RayKind::Image, [&](std::size_t i) {
        return texture::pigment_color(context.scene.textures, sky.layers[i], state.ray.direction, around);
    });
}

}  // namespace

void sky_colors(const Context& context, const SegmentTile& tile, HitMask missed, scene::Color* out)
{
    constexpr int kFewest = 3;              // rays whose pigments are worth being asked for together
    constexpr std::size_t kMostLayers = 4;  // skies have one or two
    const texture::Sky& sky = context.scene.sky;
    if (sky.layers.empty() || sky.layers.size() > kMostLayers || std::popcount(missed) < kFewest)
        return for_each_hit(missed, [&](std::size_t k) { out[k] = sky_color(context, tile.state(k)); });
    texture::Points directions;
    std::array<texture::Surroundings, csg::kTileRays> around;
    texture::Around each_around;
    for_each_hit(missed, [&](std::size_t k) {
        const glm::dvec3& direction = tile.state(k).ray.direction;
        around[directions.size()] = {{}, {}, direction};
        each_around[directions.size()] = &around[directions.size()];
        directions.add(direction);
    });
    directions.pad();
    std::array<texture::ColorPoints, kMostLayers> colors;
    for (std::size_t i = 0; i < sky.layers.size(); ++i)
        texture::pigment_colors(context.scene.textures, sky.layers[i], directions, each_around, colors[i]);
    std::size_t n = 0;
    for_each_hit(missed, [&](std::size_t k) {
        const bool mirrored = tile.state(k).kind != plan::RayKind::Image;
        out[k] = seen_sky(sky, mirrored, [&](std::size_t i) { return colors[i].at(n); });
        ++n;
    });
}

}  // namespace trace
