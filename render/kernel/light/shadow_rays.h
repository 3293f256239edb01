#pragma once

#include "csg/base/tolerance.h"
#include "render/kernel/context/shade_scratch.h"

#include <algorithm>
#include <bit>

/// Steps of TileShader over all hits of a tile.
namespace trace {

/// Where the shadow rays of a tile's first `count` hits begin and end, as Tolerance::shadow_from has it (`least`: its
/// `shadow`); hits too near to the light for one.
inline HitMask find_shadow_ends(double least, const TileHits& at, const csg::HitTile& hits, const TileLight& light,
                                ShadowEnds& ends, int count)
{
    using numbers::lanes::Double;
    HitMask near = 0;
    for (int i = 0; i < count; i += numbers::lanes::kDoubles) {
        const auto get = [i](const TileLanes& lanes) { return Double::load_aligned(lanes.data() + i); };
        const Double largest = xsimd::max(xsimd::max(xsimd::abs(get(at.x)), xsimd::abs(get(at.y))),
                                          xsimd::max(xsimd::abs(get(at.z)), get(hits.t)));
        const Double from = xsimd::max(Double(least), Double(csg::Tolerance::kCoarse) * largest),
                     to = get(light.distance) - from;
        near |= HitMask{numbers::lanes::mask(to <= from)} << i;
        from.store_aligned(ends.from.data() + i);
        to.store_aligned(ends.to.data() + i);
    }
    return near;
}

/// Hits, of the first so many, from which the light is not nearer than this.
inline HitMask beyond(const TileLight& light, double distance, int count)
{
    using numbers::lanes::Double;
    HitMask near = 0;
    for (int i = 0; i < count; i += numbers::lanes::kDoubles)
        near |= HitMask{numbers::lanes::mask(Double::load_aligned(light.distance.data() + i) < Double(distance))} << i;
    return ~near;
}

/// A shadow ray for each of these hits in scratch.shadow.rays, from the lamp where that is one point. True: ray i is
/// hit i's; otherwise scratch.shadow.lane says whose it is.
inline bool shadow_rays(ShadeScratch& scratch, HitMask asking, const glm::dvec3* lamp)
{
    csg::RayTile& beam = scratch.shadow.rays;
    const TileLight& toward = scratch.lamp.light;
    const ShadowEnds& ends = scratch.shadow.ends;
    beam.count = std::popcount(asking);
    beam.common_origin = lamp != nullptr;
    if (asking == first_hits(beam.count)) {
        const auto count = static_cast<std::size_t>(beam.count);
        std::copy_n(ends.from.begin(), count, beam.t_min.begin());
        std::copy_n(ends.to.begin(), count, beam.t_max.begin());
        const auto put = [&](TileLanes& origin, TileLanes& direction, const TileLanes& point, int axis,
                             const TileLanes& to_light) {
            if (lamp != nullptr) {
                std::fill_n(origin.begin(), count, (*lamp)[axis]);
                for (std::size_t i = 0; i < count; ++i) direction[i] = -to_light[i];
            } else {
                std::copy_n(point.begin(), count, origin.begin());
                std::copy_n(to_light.begin(), count, direction.begin());
            }
        };
        put(beam.ox, beam.dx, scratch.hits.x, 0, toward.x);
        put(beam.oy, beam.dy, scratch.hits.y, 1, toward.y);
        put(beam.oz, beam.dz, scratch.hits.z, 2, toward.z);
        return true;
    }
    std::size_t ray = 0;
    for_each_hit(asking, [&](std::size_t k) {
        const glm::dvec3 direction = toward.direction(k);
        const csg::Ray shadow = lamp != nullptr ? csg::Ray{*lamp, -direction}
                                                : csg::Ray{scratch.hits.point(k), direction};
        beam.set(ray, shadow, ends.from[k], ends.to[k]);
        scratch.shadow.lane[ray++] = static_cast<std::uint8_t>(k);
    });
    return false;
}

}  // namespace trace
