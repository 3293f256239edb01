#pragma once

#include "csg/freeform/revolution/axis_ray.h"
#include "csg/freeform/revolution/lathe.h"

#include <bit>

/// Which arcs of a lathe are asked, in vector lanes.
namespace csg {

/// Where all circles of an arc lie on one side of what a ray sweeps about the axis. A lane has an arc, or a ray.
inline lanes::Bool passes_by(const AxisSweep<lanes::Double>& ray, const lanes::Double& low, const lanes::Double& high,
                             const lanes::Double& nearest, const lanes::Double& farthest)
{
    using lanes::Double;
    const Double zero(0.0), below = low - ray.foot, over = high - ray.foot;
    const Double least = xsimd::max(zero, xsimd::max(below, zero - over)), most = xsimd::max(zero - below, over);
    return (ray.beyond(farthest, least) < zero) | (ray.beyond(nearest, most) > zero);
}

/// f(arc) in order for those that `lanes` does not miss: lanes.misses(reaches, at) has a bit a lane from `at` on.
template <class Lanes, class F>
inline void Lathe::each_near(const Lanes& lanes, F&& f) const
{
    constexpr std::size_t kEight = Reaches::kArcs;
    const auto near = [&](const Reaches& reach, std::size_t most) {
        std::uint32_t missed = 0;
        for (int at = 0; at < static_cast<int>(kEight); at += lanes::kDoubles) missed |= lanes.misses(reach, at) << at;
        return ~missed & (most < kEight ? (1u << most) - 1 : 0xffu);
    };
    const auto ask = [&](std::size_t b) {
        for (std::uint32_t left = near(reaches_[b], arcs_.size() - b * kEight); left != 0; left &= left - 1)
            f(b * kEight + static_cast<std::size_t>(std::countr_zero(left)));
    };
    if (groups_.empty()) {
        for (std::size_t b = 0; b < reaches_.size(); ++b) ask(b);
        return;
    }
    for (std::size_t g = 0; g < groups_.size(); ++g)
        for (std::uint32_t left = near(groups_[g], reaches_.size() - g * kEight); left != 0; left &= left - 1)
            ask(g * kEight + static_cast<std::size_t>(std::countr_zero(left)));
}

}  // namespace csg
