#pragma once

#include <glm/glm.hpp>

#include <cmath>

/// What the pattern and the normal `quilted` share (spec 4, 5.2).
namespace texture {

/// Offset from the middle of the unit cell. Negative integers belong to the cell below, as in POV-Ray.
inline glm::dvec3 quilt_offset(const glm::dvec3& p)
{
    const auto cell = [](double v) { return v >= 0.0 ? std::floor(v) : -std::floor(-v) - 1.0; };
    return {p.x - cell(p.x) - 0.5, p.y - cell(p.y) - 0.5, p.z - cell(p.z) - 0.5};
}

inline double quilt_height(double t, double control0, double control1)
{
    return 1.154700538 * (t * t * t + 3.0 * t * (1.0 - t) * (1.0 - t) * control0 + 3.0 * t * t * (1.0 - t) * control1);
}

}  // namespace texture
