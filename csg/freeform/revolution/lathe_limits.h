#pragma once

#include "csg/freeform/revolution/axis_ray.h"

namespace csg {

struct LatheLimits {
    // Of the parameter, 0 to 1 along a segment: the step that is this small has squared the error before it.
    static constexpr double kClose = 1e-12;
    static constexpr double kNarrow = 1e-9;  // the same: what turns twice within that is a tangent
    static constexpr int kMostCells = 400;   // a tangent takes some 60; more are rounding alone
    static constexpr double kRoom = 1e-9;    // of heights that are compared with a range
};

/// The heights of a range of a ray that is not level, a little more: an arc passed there is none of rounding.
template <class T>
inline void lathe_heights(const AxisRayOf<T>& ray, const T& from, const T& to, T& low, T& high)
{
    const T part(LatheLimits::kRoom), room = part * (lanes::size_of(ray.foot) + ray.nearest);
    const T below = ray.height_at(ray.sooner(from)), over = ray.height_at(ray.later(to));
    const T least = lanes::smaller(below, over), most = lanes::larger(below, over);
    low = least - (room + part * lanes::size_of(least));
    high = most + (room + part * lanes::size_of(most));
}

}  // namespace csg
