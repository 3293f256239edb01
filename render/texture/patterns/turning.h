#pragma once

#include "numbers/functions/lane_functions.h"
#include "numbers/lane_arithmetic.h"
#include "render/texture/points/angle.h"
#include "render/texture/quilt.h"

#include <numbers>

/// Formulas of geometric patterns for one point and for a point a lane (T: a number or vector lanes; spec 4, 5.2).
namespace texture {

/// Angle of a spiral's arm about z, from the arc sine of y / r: 0 to 2 pi.
template <class T>
inline T arm_angle(const T& x, const T& y, const T& r)
{
    using numbers::lanes::choose;
    const T zero(0.0), a = numbers::asin(y / r);
    return choose(r == zero, zero, choose(x >= zero, T(std::numbers::pi / 2) + a, T(3 * std::numbers::pi / 2) - a));
}

template <class T>
inline T spiral_radius(const T& x, const T& y)
{
    return numbers::lanes::root_of(x * x + y * y);
}

/// z + r + arms * angle / 2 pi, to which the turbulence is added.
template <class T>
inline T spiral_phase(double arms, const T& x, const T& y, const T& z)
{
    const T r = spiral_radius(x, y);
    return z + r + T(arms) * arm_angle(x, y, r) / T(kTau);
}

/// 0 to 1 and back over one unit.
template <class T>
inline T triangle(const T& v)
{
    using numbers::lanes::choose;
    using std::floor;
    const T one(1.0), two(2.0), o = choose(v >= T(0.0), v - floor(v), v + one + floor(numbers::lanes::size_of(v)));
    return choose(o < T(0.5), two * o, two * (one - o));
}

template <class T>
inline T radial(const T& x, const T& z)
{
    const T axis(0.001);  // POV-Ray's: nearer to the y axis than this counts as on it
    const numbers::lanes::Truth<T> near_x = numbers::lanes::size_of(x) < axis,
                                   near_z = numbers::lanes::size_of(z) < axis;
    return numbers::lanes::choose(near_x & near_z, T(0.25),
                                  T(0.25) + (numbers::atan2(x, z) + T(std::numbers::pi)) / T(kTau));
}

/// control0, control1: of its height.
template <class T>
inline T quilted(const T& x, const T& y, const T& z, double control0, double control1)
{
    using numbers::lanes::size_of;
    const T u = quilt_offset(x), v = quilt_offset(y), w = quilt_offset(z),
            k = quilt_height(numbers::lanes::root_of(u * u + v * v + w * w), control0, control1);
    return (size_of(k * u) + size_of(k * v) + size_of(k * w)) / T(3.0);
}

}  // namespace texture
