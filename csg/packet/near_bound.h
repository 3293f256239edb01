#pragma once

#include "csg/items/world_data.h"
#include "csg/packet/lanes/lane_solids.h"
#include "csg/packet/lanes/tile_rays.h"

#include <array>

/// Bounds against a tile of rays.
namespace csg {

/// The rays without those that surely miss a guard's bound, if that is one convex solid: passes() of many. until(k):
/// its `end` of ray k.
template <class Rays, class Until>
inline RayMask near_bound(const WorldData& world, const BoundingGuard& guard, const Rays& rays, RayMask mask,
                          Until&& until)
{
    using lanes::Double;
    if (guard.programs.size() != 1 || world.programs[guard.programs[0]].nodes.size() != 1) return mask;
    const Node& bound = world.programs[guard.programs[0]].nodes[0];
    if (bound.inverted || !lanes::has_test(world.store, bound.solid)) return mask;
    RayMask met = 0;
    lanes::with_test(world.store, bound.solid, rays, [&](const auto& at) {
        each_vector(mask, [&](int i) {
            alignas(64) std::array<double, lanes::kDoubles> ends;
            for (std::size_t k = 0; k < ends.size(); ++k) ends[k] = until(static_cast<std::size_t>(i) + k);
            const Double end = Double::load_aligned(ends.data()), begin = Double::load_aligned(rays.t_min.data() + i);
            const lanes::Intervals in = at(i);
            const lanes::Bool within = in.met & (in.exit >= begin) & (in.entry <= end);
            met |= RayMask{lanes::mask(guard.shadows_pass ? within | (end < lanes::beyond()) : within)} << i;
        });
    });
    return mask & met;
}

}  // namespace csg
