#include "render/trace/shade/shade_context.h"

#include <algorithm>
#include <cmath>

namespace trace {
namespace {

scene::Color layered_sky(const Context& context, const RayState& state, const texture::Sky& sky, bool see_through)
{
    glm::vec3 sum(0), filter(1);
    for (std::size_t i = sky.layers.size(); i-- > 0;) {
        const texture::Surroundings around{{}, {}, state.ray.direction};
        const scene::Color c =
            texture::pigment_color(context.scene.textures, sky.layers[i], state.ray.direction, around);
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

scene::Color legacy_sky(const Context& context, const RayState& state, const texture::Sky& sky)
{
    scene::Color sum, filter{1, 1, 1, 1, 1};
    float share = 1;
    for (std::size_t i = sky.layers.size(); i-- > 0;) {
        const texture::Surroundings around{{}, {}, state.ray.direction};
        const scene::Color c =
            texture::pigment_color(context.scene.textures, sky.layers[i], state.ray.direction, around);
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

}  // namespace

scene::Color sky_color(const Context& context, const RayState& state)
{
    const texture::Sky& sky = context.scene.sky;
    const bool mirrored = state.kind != plan::RayKind::Image;
    if (sky.layers.empty()) {
        scene::Color c = sky.background;
        if (mirrored) c.filter = c.transmit = 0.0f;
        return c;
    }
    if (!sky.legacy) return layered_sky(context, state, sky, sky.alpha_output && !mirrored);
    if (sky.alpha_output && !mirrored) return {0, 0, 0, 0, 1};
    return legacy_sky(context, state, sky);
}

}  // namespace trace
