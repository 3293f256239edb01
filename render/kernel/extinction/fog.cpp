#include "csg/base/points.h"
#include "numbers/functions/functions.h"
#include "numbers/functions/lane_functions.h"
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

using numbers::lanes::choose;
using numbers::lanes::Double;

/// Mean density of ground fog along a segment between two heights (spec 2, 16.2). V is double or lanes::Double.
template <class V>
V mean_density(const V& a, const V& b)
{
    const V none(0.0), full(1.0), apart = a - b;
    const auto below_a = a <= none, below_b = b <= none;
    const auto bent = [](const auto& below, const V& height) { return choose(below, height, numbers::atan(height)); };
    // Not a number, with a fog_alt of 0, counts as level: above the offset there is no fog then.
    const auto level = (a > none) & (b > none) & !(numbers::lanes::size_of(apart) > V(kNearlyZero));
    const V mean = choose(level, full / (full + a * a), (bent(below_a, a) - bent(below_b, b)) / apart);
    return choose(below_a & below_b, full, mean);
}

constexpr double kUnseen = 0x1p-55;  // less than half of the last bit of 1

/// What the turbulence of a fog, times its depth, does not exceed: no octave has more than 1.5.
double most_turbulence(const texture::Fog& fog)
{
    double sum = 0.0, share = 1.5;
    for (int k = 0; k < fog.turbulence.octaves; ++k, share *= std::abs(fog.turbulence.omega)) sum += share;
    return std::max(1.0, std::abs(fog.turb_depth) * sum);
}

/// The factor of a fog's turbulence at the end of a length; 0 where the length is so far beyond the fog's distance that
/// no noise could change the result.
/// \param most  most_turbulence()
template <class V>
V seen_turbulence(const texture::Fog& fog, double most, const V& length)
{
    const V near = numbers::exp(-length / V(fog.distance));
    return choose(near * V(most) > V(kUnseen), near, V(0.0));
}

/// Where turbulence is asked for.
glm::dvec3 turbulent_place(const texture::Fog& fog, const csg::Ray& ray, double length)
{
    return ray.at(length / 2.0) * fog.turbulence.amount;
}

/// near: seen_turbulence(); turbulence: the sum at its place, of any value where that is 0. P and D: of a ray or of a
/// ray a lane.
template <class P, class D, class V>
V fog_transmission(const texture::Fog& fog, const P& origin, const D& direction, const V& length, const V& near,
                   const V& turbulence)
{
    const V full(1.0), none(0.0), lifted = V(fog.turb_depth) * turbulence;
    const V effective = choose(near > none, length * (full - near * choose(lifted < full, lifted, full)), length);
    V density = full;
    if (fog.ground) {
        const V offset(fog.offset), altitude(fog.altitude);
        const V a = (csg::lanes::dot(origin, fog.up) - offset) / altitude;
        const V b = (csg::lanes::dot(csg::lanes::advanced(origin, length, direction), fog.up) - offset) / altitude;
        density = mean_density(a, b);
    }
    const V passes = numbers::exp(-effective * density / V(fog.distance)),
            clear(static_cast<double>(fog.color.transmit));
    return choose(passes < clear, clear, passes);
}

double fog_transmission(const Context& context, const texture::Fog& fog, const csg::Ray& ray, double length)
{
    if (even(fog)) return trace::fog_transmission(fog, length);
    const double near = fog.turbulent ? seen_turbulence(fog, most_turbulence(fog), length) : 0.0;
    const scene::Turbulence& t = fog.turbulence;
    const double n = near > 0.0 ? texture::scalar_turbulence(turbulent_place(fog, ray, length), t.octaves, t.lambda,
                                                             t.omega, context.scene.textures.noise_generator)
                                : 0.0;
    return fog_transmission(fog, ray.origin, ray.direction, length, near, n);
}

void add_fog(const texture::Fog& fog, double transmission, Air& air)
{
    const auto a = static_cast<float>(transmission);
    air.glow += (1.0f - a) * fog.color.rgb();
    air.share *= a * ((1.0f - fog.color.filter) + fog.color.filter * fog.color.rgb());
}

template <class F>
void each_vector(const csg::RayTile& rays, F&& f)
{
    for (std::size_t i = 0; i < static_cast<std::size_t>(rays.count); i += numbers::lanes::kDoubles) f(i);
}

/// The sum of a fog's turbulence for the rays that are near enough to show it.
void find_turbulence(const Context& context, const texture::Fog& fog, const csg::RayTile& rays, HitMask hits,
                     const TileLanes& length, const TileLanes& near, TileLanes& out)
{
    texture::Points places;
    HitMask asked = 0;
    for_each_hit(hits, [&](std::size_t k) {
        if (!(near[k] > 0.0)) return;
        asked |= HitMask{1} << k;
        places.add(turbulent_place(fog, rays.ray(static_cast<int>(k)), length[k]));
    });
    if (asked == 0) return;
    places.pad();
    texture::Values found;
    const scene::Turbulence& t = fog.turbulence;
    texture::scalar_turbulence_points(places, t.octaves, t.lambda, t.omega, context.scene.textures.noise_generator,
                                      found);
    std::size_t next = 0;
    for_each_hit(asked, [&](std::size_t k) { out[k] = found[next++]; });
}

/// A fog that is not the same everywhere, over the lengths of many rays.
void add_uneven_fog(const Context& context, const texture::Fog& fog, const csg::RayTile& rays, HitMask hits,
                    const TileLanes& length, std::array<Air, csg::kTileRays>& air)
{
    alignas(64) TileLanes near{}, lifts{}, passes;
    if (fog.turbulent) {
        const double most = most_turbulence(fog);
        each_vector(rays, [&](std::size_t i) {
            seen_turbulence(fog, most, Double::load_aligned(&length[i])).store_aligned(&near[i]);
        });
        find_turbulence(context, fog, rays, hits, length, near, lifts);
    }
    each_vector(rays, [&](std::size_t i) {
        const auto load = [i](const auto& row) { return Double::load_aligned(&row[i]); };
        const csg::lanes::Points origin{load(rays.ox), load(rays.oy), load(rays.oz)};
        const csg::lanes::Directions direction{load(rays.dx), load(rays.dy), load(rays.dz)};
        fog_transmission(fog, origin, direction, load(length), load(near), load(lifts)).store_aligned(&passes[i]);
    });
    for_each_hit(hits, [&](std::size_t k) { add_fog(fog, passes[k], air[k]); });
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
