#include "numbers/functions/functions.h"
#include "render/texture/noise/noise.h"
#include "render/texture/noise/noise_points.h"
#include "render/kernel/extinction/even_fog.h"
#include "render/kernel/extinction/uneven_fog.h"
#include "render/kernel/context/context.h"
#include "render/kernel/tile/nearly_zero.h"

#include <algorithm>
#include <cmath>

namespace trace {
namespace {

/// Mean density of ground fog along a segment between two heights (spec 2, 16.2).
double mean_density(double a, double b)
{
    if (a <= 0.0 && b <= 0.0) return 1.0;
    if (a <= 0.0) return (numbers::atan(b) - a) / (b - a);
    if (b <= 0.0) return (numbers::atan(a) - b) / (a - b);
    return std::abs(a - b) <= kNearlyZero ? 1.0 / (1.0 + a * a) : (numbers::atan(a) - numbers::atan(b)) / (a - b);
}

constexpr double kUnseen = 0x1p-55;  // less than half of the last bit of 1

/// What the turbulence of a fog, times its depth, does not exceed: no octave has more than 1.5.
double most_turbulence(const texture::Fog& fog)
{
    double sum = 0.0, share = 1.5;
    for (int k = 0; k < fog.turbulence.octaves; ++k, share *= std::abs(fog.turbulence.omega)) sum += share;
    return std::max(1.0, std::abs(fog.turb_depth) * sum);
}

/// How much of its turbulence a fog shows at the end of a length; 0: none. Far behind the fog's distance no noise is
/// large enough to change 1.
double seen_turbulence(const texture::Fog& fog, double length)
{
    const double near = fog.turbulent ? numbers::exp(-length / fog.distance) : 0.0;
    return near * most_turbulence(fog) > kUnseen ? near : 0.0;
}

/// Where turbulence is asked for.
glm::dvec3 turbulent_place(const texture::Fog& fog, const csg::Ray& ray, double length)
{
    return ray.at(length / 2.0) * fog.turbulence.amount;
}

/// near: seen_turbulence(); turbulence: the sum at its place, of any value where that is 0.
double fog_transmission(const texture::Fog& fog, const csg::Ray& ray, double length, double near, double turbulence)
{
    double effective = length, density = 1.0;
    if (near > 0.0) effective = length * (1.0 - near * std::min(1.0, fog.turb_depth * turbulence));
    if (fog.ground) {
        const double a = (glm::dot(ray.origin, fog.up) - fog.offset) / fog.altitude;
        const double b = (glm::dot(ray.at(length), fog.up) - fog.offset) / fog.altitude;
        density = mean_density(a, b);
    }
    return std::max(numbers::exp(-effective * density / fog.distance), static_cast<double>(fog.color.transmit));
}

double fog_transmission(const Context& context, const texture::Fog& fog, const csg::Ray& ray, double length)
{
    if (even(fog)) return trace::fog_transmission(fog, length);
    const double near = seen_turbulence(fog, length);
    const scene::Turbulence& t = fog.turbulence;
    const double n = near > 0.0 ? texture::scalar_turbulence(turbulent_place(fog, ray, length), t.octaves, t.lambda,
                                                             t.omega, context.scene.textures.noise_generator)
                                : 0.0;
    return fog_transmission(fog, ray, length, near, n);
}

void add_fog(const texture::Fog& fog, double transmission, Air& air)
{
    const auto a = static_cast<float>(transmission);
    air.glow += (1.0f - a) * fog.color.rgb();
    air.share *= a * ((1.0f - fog.color.filter) + fog.color.filter * fog.color.rgb());
}

/// A fog that is not the same everywhere, over the lengths of many rays.
void add_uneven_fog(const Context& context, const texture::Fog& fog, const csg::RayTile& rays, HitMask hits,
                    const TileLanes& length, std::array<Air, csg::kTileRays>& air)
{
    std::array<double, csg::kTileRays> near;
    texture::Points places;
    texture::Values turbulence;
    for_each_hit(hits, [&](std::size_t k) {
        near[k] = seen_turbulence(fog, length[k]);
        if (near[k] > 0.0) places.add(turbulent_place(fog, rays.ray(static_cast<int>(k)), length[k]));
    });
    if (places.count != 0) {
        places.pad();
        const scene::Turbulence& t = fog.turbulence;
        texture::scalar_turbulence_points(places, t.octaves, t.lambda, t.omega, context.scene.textures.noise_generator,
                                          turbulence);
    }
    std::size_t next = 0;
    for_each_hit(hits, [&](std::size_t k) {
        const double n = near[k] > 0.0 ? turbulence[next++] : 0.0;
        add_fog(fog, fog_transmission(fog, rays.ray(static_cast<int>(k)), length[k], near[k], n), air[k]);
    });
}

}  // namespace

void add_fogs(const Context& context, const csg::RayTile& rays, HitMask hits, const TileLanes& length,
              std::array<Air, csg::kTileRays>& air)
{
    std::array<Air, csg::kTileRays> own;
    for (const texture::Fog& fog : context.scene.fogs) {
        if (!even(fog)) {
            add_uneven_fog(context, fog, rays, hits, length, own);
            continue;
        }
        for_each_hit(hits, [&](std::size_t k) { add_fog(fog, trace::fog_transmission(fog, length[k]), own[k]); });
    }
    for_each_hit(hits, [&](std::size_t k) {
        own[k].clear = scene::grey(own[k].share);
        air[k].behind(own[k]);
    });
}

glm::vec3 fog_share(const Context& context, const csg::Ray& ray, double length)
{
    glm::vec3 share(1);
    for (const texture::Fog& fog : context.scene.fogs)
        share *= static_cast<float>(fog_transmission(context, fog, ray, length)) *
                 ((1.0f - fog.color.filter) + fog.color.filter * fog.color.rgb());
    return share;
}

}  // namespace trace
