#pragma once

#include "csg/freeform/shared/intersection_list.h"
#include "csg/freeform/shared/local_rays.h"
#include "csg/solids/shared/slab.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>

/// Convex solids along a ray, or along a ray a lane.
namespace csg {

/// Moves the ends that lie beyond a surface onto it. Newton's steps never pass the nearest root of a convex function;
/// they end after one no longer than `close`, small enough that what is left is its square.
/// \param beyond beyond(end, value, slope): along the ray, at most 0 inside
/// \param way    1 for where rays go in, -1 for where they come out
/// \param other  the other end, which is not passed
/// \param met    those that are asked for; left are those that meet the inside
/// \return the ends that had to be moved
template <class V, class Beyond>
inline lanes::Truth<V> move_onto_convex(const Beyond& beyond, double way, V& end, const V& other, double close,
                                        lanes::Truth<V>& met)
{
    lanes::Truth<V> moving = met, moved = met;
    for (int i = 0; i < 100; ++i) {
        V value, slope;
        beyond(end, value, slope);
        moving = moving & (value > V(0.0));
        if (i == 0) moved = moving;
        if (lanes::mask(moving) == 0) break;
        const V step = lanes::negated(value) / slope, next = end + step;
        const lanes::Truth<V> nears = (slope * V(way) < V(0.0)) & !((other - next) * V(way) < V(0.0));
        met = met & (nears | !moving);
        moving = moving & nears;
        end = lanes::choose(moving, next, end);
        moving = moving & (lanes::size_of(step) > V(close));
    }
    return moved;
}

/// Tells many rays of a convex solid.
/// \param inside_of inside_of(origins, ways, first, ends): which of the rays from the `first` on, a ray a lane, have a
///                  part in it, and the part's ends
template <class Inside>
inline void convex_in_lanes(std::span<const Ray> rays, IntersectionList* out, const Inside& inside_of)
{
    constexpr std::size_t kWide = LocalRays::kWide;
    const LocalRays local(rays);
    for (std::size_t at = 0; at < rays.size(); at += kWide) {
        const std::size_t count = std::min(kWide, rays.size() - at);
        EndsOf<lanes::Double> ends{};
        std::uint32_t met = lanes::mask(inside_of(local.origins(at), local.ways(at), at, ends)) & ((1u << count) - 1u);
        alignas(64) std::array<double, kWide> entry, exit, entry_face, exit_face;
        lanes::store(ends.entry, entry.data());
        lanes::store(ends.exit, exit.data());
        lanes::store(ends.entry_face, entry_face.data());
        lanes::store(ends.exit_face, exit_face.data());
        for (; met != 0; met &= met - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(met));
            if (out[at + k].enter(entry[k], static_cast<std::uint32_t>(entry_face[k])))
                out[at + k].leave(exit[k], static_cast<std::uint32_t>(exit_face[k]));
        }
    }
}

}  // namespace csg
