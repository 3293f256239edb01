#pragma once

#include "csg/base/hit.h"
#include "numbers/lanes.h"
#include "render/light/illuminate.h"
#include "render/kernel/tile/hit_mask.h"

#include <array>

/// The hits of a tile as arrays, and a light over them in vector lanes. The
/// operations are those of light::illuminate in the same order, so a hit shaded alone has the same bits.
namespace trace {

using TileLanes = std::array<double, csg::kTileRays>;

/// Points, and normals that face the viewer. Places without a hit are zero.
using TileHits = csg::ShadingPoints;

/// Turns normals that face along their rays; which.
inline HitMask turn_to_viewer(const csg::RayTile& rays, TileHits& places)
{
    using numbers::lanes::Double;
    HitMask turned = 0;
    for (int i = 0; i < rays.count; i += numbers::lanes::kDoubles) {
        const auto get = [i](const TileLanes& lanes) { return Double::load_aligned(lanes.data() + i); };
        const Double x = get(places.nx), y = get(places.ny), z = get(places.nz);
        const auto away = x * get(rays.dx) + y * get(rays.dy) + z * get(rays.dz) > Double(0.0);
        const HitMask bits = numbers::lanes::mask(away);
        if (bits == 0) continue;
        turned |= bits << i;
        xsimd::select(away, -x, x).store_aligned(places.nx.data() + i);
        xsimd::select(away, -y, y).store_aligned(places.ny.data() + i);
        xsimd::select(away, -z, z).store_aligned(places.nz.data() + i);
    }
    return turned;
}

/// Directions (unit) and distances from the hits to a light.
struct alignas(64) TileLight {
    alignas(64) TileLanes x, y, z, distance;

    glm::dvec3 direction(std::size_t i) const { return {x[i], y[i], z[i]}; }
    void set(std::size_t i, const light::Illumination& lit)
    {
        x[i] = lit.direction.x;
        y[i] = lit.direction.y;
        z[i] = lit.direction.z;
        distance[i] = lit.distance;
    }
};

/// A place for each lane.
struct LanePoints {
    numbers::lanes::Double x, y, z;
};

/// light::toward for light that comes from at(i) to the hits from i on in lanes, 0 <= i < count.
template <class At>
inline void toward_places(const At& at, const TileHits& hits, int count, TileLight& out)
{
    using numbers::lanes::Double;
    for (int i = 0; i < count; i += numbers::lanes::kDoubles) {
        const LanePoints from = at(i);
        const Double x = from.x - Double::load_aligned(hits.x.data() + i),
                     y = from.y - Double::load_aligned(hits.y.data() + i),
                     z = from.z - Double::load_aligned(hits.z.data() + i);
        const Double distance = xsimd::sqrt(x * x + y * y + z * z);
        distance.store_aligned(out.distance.data() + i);
        (x / distance).store_aligned(out.x.data() + i);
        (y / distance).store_aligned(out.y.data() + i);
        (z / distance).store_aligned(out.z.data() + i);
    }
}

/// The same of a lamp, moved by `offset`.
inline void toward_lamp(const light::Light& light, const TileHits& hits, int count, TileLight& out,
                        const glm::dvec3& offset = glm::dvec3(0))
{
    using numbers::lanes::Double;
    const glm::dvec3 at = light.location + offset;
    const LanePoints place{Double(at.x), Double(at.y), Double(at.z)};
    if (!light::seen_in_one_direction(light)) return toward_places([&](int) { return place; }, hits, count, out);
    const glm::dvec3 direction = light::toward(light, glm::dvec3(0), offset).direction;
    const Double dx(direction.x), dy(direction.y), dz(direction.z);
    for (int i = 0; i < count; i += numbers::lanes::kDoubles) {
        const Double x = place.x - Double::load_aligned(hits.x.data() + i),
                     y = place.y - Double::load_aligned(hits.y.data() + i),
                     z = place.z - Double::load_aligned(hits.z.data() + i);
        (x * dx + y * dy + z * dz).store_aligned(out.distance.data() + i);
        dx.store_aligned(out.x.data() + i);
        dy.store_aligned(out.y.data() + i);
        dz.store_aligned(out.z.data() + i);
    }
}

}  // namespace trace
