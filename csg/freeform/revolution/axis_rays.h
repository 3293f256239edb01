#pragma once

#include "csg/freeform/revolution/axis_ray.h"
#include "csg/freeform/shared/intersection_list.h"
#include "csg/freeform/shared/local_rays.h"

#include <algorithm>
#include <bit>
#include <span>

namespace csg {

/// Several rays, a ray a lane.
class AxisRays : public AxisRayOf<lanes::Double> {
public:
    using Double = lanes::Double;
    using Bool = lanes::Bool;
    using Mask = std::uint32_t;
    static constexpr std::size_t kWide = LocalRays::kWide;

    using AxisRayOf::AxisRayOf;
};

/// Asks a solid of revolution for rays in lanes: tile(rays as their axis sees them, those to be answered, rays, out)
/// for as many as there are lanes. Level ones are asked one by one.
template <class Shape, class Tile>
inline void intersect_in_lanes(const Shape& shape, std::span<const Ray> rays, IntersectionList* out, Tile&& tile)
{
    constexpr std::size_t kFewest = 3;  // fewer are told sooner one by one
    const LocalRays local(rays);
    for (std::size_t at = 0; at < rays.size(); at += AxisRays::kWide) {
        const std::size_t count = std::min(AxisRays::kWide, rays.size() - at);
        AxisRays::Mask alone = (1u << count) - 1u;
        if (count >= kFewest) {
            const auto [x, y, z] = local.origins(at);
            const auto [dx, dy, dz] = local.ways(at);
            const AxisRays several({x, y, z}, {dx, dy, dz});
            const AxisRays::Mask known = lanes::mask(several.valid()) & alone;
            alone = known & lanes::mask(several.level());
            if (known != alone) tile(several, known & ~alone, rays.subspan(at, count), out + at);
        }
        for (; alone != 0; alone &= alone - 1) {
            const std::size_t k = at + static_cast<std::size_t>(std::countr_zero(alone));
            shape.intersect(rays[k], out[k]);
        }
    }
}

}  // namespace csg
