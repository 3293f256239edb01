#pragma once

#include "csg/base/hit.h"
#include "csg/base/lanes.h"
#include "render/light/illuminate.h"

#include <array>

/// The hits of a tile as arrays, and a light over them in vector lanes. Compiled once per instruction set. The
/// operations are those of light::illuminate in the same order, so a hit shaded alone has the same bits.
namespace trace {

using TileLanes = std::array<double, csg::kTileRays>;

/// Points, and normals that face the viewer. Places without a hit are zero.
using TileHits = csg::PlaceTile;

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

/// light::toward for a light at one point, hits 0 <= i < count.
inline void toward_point(const light::Light& light, const TileHits& hits, int count, TileLight& out)
{
    using csg::lanes::Double;
    const glm::dvec3 at = light.location + glm::dvec3(0);
    const Double ax(at.x), ay(at.y), az(at.z);
    for (int i = 0; i < count; i += csg::lanes::kDoubles) {
        const Double x = ax - Double::load_aligned(hits.x.data() + i), y = ay - Double::load_aligned(hits.y.data() + i),
                     z = az - Double::load_aligned(hits.z.data() + i);
        const Double distance = xsimd::sqrt(x * x + y * y + z * z);
        distance.store_aligned(out.distance.data() + i);
        (x / distance).store_aligned(out.x.data() + i);
        (y / distance).store_aligned(out.y.data() + i);
        (z / distance).store_aligned(out.z.data() + i);
    }
}

}  // namespace trace
