#pragma once

#include "csg/freeform/revolution/axis_ray.h"

/// What one ray and rays in lanes through a lathe agree on.
namespace csg {

struct LatheLimits {
    // Of the parameter, 0 to 1 along a segment: the step that is this small has squared the error before it.
    static constexpr double kClose = 1e-12;
    static constexpr double kNarrow = 1e-9;  // the same: what turns twice within that is a tangent
    static constexpr int kMostCells = 400;   // a tangent takes some 60; more are rounding alone
    static constexpr double kRoom = 1e-9;    // of heights that are compared with a range
};

/// The heights of a range of a ray that is not level, a little more: an arc passed there is none of rounding.
inline void lathe_heights(const AxisRay& ray, double from, double to, double& low, double& high)
{
    const double earliest = ray.sooner(from), latest = ray.later(to),
                 room = LatheLimits::kRoom * (std::abs(ray.foot) + ray.nearest);
    const double below = ray.height_at(earliest), over = ray.height_at(latest);
    const auto wider = [&](double height, double sign) {
        return height + sign * (room + LatheLimits::kRoom * std::abs(height));
    };
    low = wider(glm::min(below, over), -1.0);
    high = wider(glm::max(below, over), 1.0);
}

}  // namespace csg
