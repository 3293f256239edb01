#include "render/texture/noise/noise.h"
#include "render/trace/shade/shade_context.h"

#include <algorithm>
#include <cmath>

namespace trace {
namespace {

constexpr double kSkyDistance = 2e10;  // length of a ray that meets nothing, for fog

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

/// Mean density of ground fog along a segment between two heights (spec 2, 16.2).
double mean_density(double a, double b)
{
    if (a <= 0.0 && b <= 0.0) return 1.0;
    if (a <= 0.0) return (std::atan(b) - a) / (b - a);
    if (b <= 0.0) return (std::atan(a) - b) / (a - b);
    return std::abs(a - b) <= kNearlyZero ? 1.0 / (1.0 + a * a) : (std::atan(a) - std::atan(b)) / (a - b);
}

double fog_transmission(const Context& context, const texture::Fog& fog, const csg::Ray& ray, double length)
{
    double effective = length;
    if (fog.turbulent) {
        const glm::dvec3 p = ray.at(length / 2.0) * fog.turbulence.amount;
        const double n = texture::scalar_turbulence(p, fog.turbulence.octaves, fog.turbulence.lambda,
                                                    fog.turbulence.omega, context.scene.textures.noise_generator);
        effective = length * (1.0 - std::exp(-length / fog.distance) * std::min(1.0, fog.turb_depth * n));
    }
    double density = 1.0;
    if (fog.ground) {
        const double a = (glm::dot(ray.origin, fog.up) - fog.offset) / fog.altitude;
        const double b = (glm::dot(ray.at(length), fog.up) - fog.offset) / fog.altitude;
        density = mean_density(a, b);
    }
    return std::max(std::exp(-effective * density / fog.distance), static_cast<double>(fog.color.transmit));
}

}  // namespace

scene::Color sky_color(const Context& context, const RayState& state)
{
    const texture::Sky& sky = context.scene.sky;
    const bool mirrored = state.kind == plan::RayKind::Reflection;
    if (sky.layers.empty()) {
        scene::Color c = sky.background;
        if (mirrored) c.filter = c.transmit = 0.0f;
        return c;
    }
    if (!sky.legacy) return layered_sky(context, state, sky, sky.alpha_output && !mirrored);
    if (sky.alpha_output && !mirrored) return {0, 0, 0, 0, 1};
    return legacy_sky(context, state, sky);
}

glm::vec3 fog_share(const Context& context, const csg::Ray& ray, double length)
{
    glm::vec3 share(1);
    for (const texture::Fog& fog : context.scene.fogs)
        share *= static_cast<float>(fog_transmission(context, fog, ray, length)) *
                 ((1.0f - fog.color.filter) + fog.color.filter * fog.color.rgb());
    return share;
}

scene::Color through_fog(const Context& context, const csg::Ray& ray, double length, scene::Color color)
{
    const double s = std::min(length, kSkyDistance);
    glm::vec3 glow(0), share(1);
    for (const texture::Fog& fog : context.scene.fogs) {
        const auto a = static_cast<float>(fog_transmission(context, fog, ray, s));
        glow += (1.0f - a) * fog.color.rgb();
        share *= a * ((1.0f - fog.color.filter) + fog.color.filter * fog.color.rgb());
    }
    scene::Color out = scene::Color::of(glow + color.rgb() * share);
    out.transmit = color.transmit * scene::grey(share);
    return out;
}

}  // namespace trace
