#pragma once

#include "csg/tree/program.h"

#include <cmath>

/// What decides whether places along a ray are the same, and whether it comes near a node.
namespace csg {

/// Two ends this close along a ray are one: relative to the parameter and to the size of the origin, 64 units in the
/// last place. Coincident faces of different solids come out of different formulas and differ by a few of them.
inline constexpr double kCoincidence = 64.0 * 0x1p-53;

/// The size of a ray's origin, in units of its parameter: what kCoincidence is relative to, besides the parameter.
inline double origin_reach(const Ray& ray)
{
    const glm::dvec3 o = glm::abs(ray.origin), d = glm::abs(ray.direction);
    return glm::max(o.x, glm::max(o.y, o.z)) / glm::max(d.x, glm::max(d.y, d.z));
}

/// Whether the ray meets the node's box between t_min and t_max. inverse: of its direction.
inline bool meets_box(const Node& node, const Ray& ray, const glm::dvec3& inverse, double t_min, double t_max)
{
    if (!node.test_box) return true;
    double first = t_min, last = t_max;
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const bool backward = std::signbit(inverse[i]);
        const double a = (static_cast<double>(backward ? node.upper[k] : node.lower[k]) - ray.origin[i]) * inverse[i];
        const double b = (static_cast<double>(backward ? node.lower[k] : node.upper[k]) - ray.origin[i]) * inverse[i];
        if (a > first) first = a;  // NaN keeps what was there
        if (b < last) last = b;
    }
    return first <= last + kCoincidence * std::abs(last);
}

}  // namespace csg
