#pragma once

#include "numbers/lane_arithmetic.h"

#include <glm/glm.hpp>

#include <cmath>

/// What the pattern and the normal `quilted` share (spec 4, 5.2).
namespace texture {

/// One component's offset from the middle of the unit cell. Negative integers belong to the cell below, as in POV-Ray.
template <class T>
inline T quilt_offset(const T& v)
{
    using std::floor;
    const T cell = numbers::lanes::choose(v >= T(0.0), floor(v), T(0.0) - floor(T(0.0) - v) - T(1.0));
    return v - cell - T(0.5);
}
inline glm::dvec3 quilt_offset(const glm::dvec3& p)
{
    return {quilt_offset(p.x), quilt_offset(p.y), quilt_offset(p.z)};
}

template <class T>
inline T quilt_height(const T& t, double control0, double control1)
{
    const T one(1.0), three(3.0);
    return T(1.154700538) *
           (t * t * t + three * t * (one - t) * (one - t) * T(control0) + three * t * t * (one - t) * T(control1));
}

}  // namespace texture
