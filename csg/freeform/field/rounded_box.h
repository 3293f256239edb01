#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace csg {

/// f_rounded_box of the library: how far a point is from a box, less a radius. Convex along every line: where it falls
/// below a number it does so once.
struct RoundedBox {
    glm::dvec3 half{0.0};  ///< of the box within
    double radius = 0.0;

    double operator()(const glm::dvec3& p) const
    {
        const auto beyond = [&](int k) { return std::max(0.0, std::abs(p[k]) - half[k]); };
        const double x = beyond(0), y = beyond(1), z = beyond(2);
        return std::sqrt(x * x + y * y + z * z) - radius - 1e-6;
    }
};

}  // namespace csg
