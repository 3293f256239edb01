#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace csg {

/// A point of an arc as a ray sees it.
struct LathePoint {
    double w;                      ///< parameter
    double radius, height, above;  ///< above the ray's foot
    double slope_radius, slope_above;
    double beyond;  ///< AxisRay::beyond
    bool out() const { return beyond > 0.0; }
};

/// Least and largest of a product of two numbers known at both ends, each monotone between them.
struct SlopeRange {
    double least, most;  ///< of its amount
    bool negative;
};
inline SlopeRange slope_range(double a0, double a1, double b0, double b1)
{
    const double a_least = (a0 < 0.0) == (a1 < 0.0) ? glm::min(std::abs(a0), std::abs(a1)) : 0.0;
    const double b_least = (b0 < 0.0) == (b1 < 0.0) ? glm::min(std::abs(b0), std::abs(b1)) : 0.0;
    const double a_most = glm::max(std::abs(a0), std::abs(a1)), b_most = glm::max(std::abs(b0), std::abs(b1));
    return {a_least * b_least, a_most * b_most, (a0 + a1 < 0.0) != (b0 + b1 < 0.0)};
}
/// Whether their difference cannot be 0.
inline bool apart(const SlopeRange& a, const SlopeRange& b)
{
    return a.negative != b.negative || a.least > b.most || b.least > a.most;
}

}  // namespace csg
