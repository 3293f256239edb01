#pragma once

#include "numbers/functions/lane_functions.h"
#include "numbers/lane_arithmetic.h"

#include <cmath>
#include <initializer_list>
#include <numbers>

/// Small functions that several patterns and warps share (spec 4, sections 4 and 8.2).
namespace texture {

inline constexpr double kTiny = 1e-10;  ///< the "small number" of the pattern formulas
inline constexpr double kTau = 2.0 * std::numbers::pi;

/// Counter-clockwise from +x toward +z, 0 to 1; of a number or of vector lanes.
template <class T>
inline T turn(const T& x, const T& z)
{
    using numbers::lanes::choose;
    const T zero(0.0), a = numbers::acos(x / numbers::lanes::root_of(x * x + z * z)) / T(kTau);
    return choose(z == zero, choose(x > zero, zero, T(0.5)), choose(z < zero, T(1.0) - a, a));
}

/// sin(2 pi v) for 0 <= v <= 1, by its series about the nearest quarter; 2e-16 from it at most. One for a number and
/// for vector lanes, so that both have the same bits. select(where, a, b): a or b.
template <class T, class Select>
inline T turn_sine(const T& v, Select&& select)
{
    using std::floor;
    const T quarter = floor(T(4.0) * v + T(0.5)), x = T(kTau) * (v - T(0.25) * quarter), z = x * x;
    // 1 / n! with alternating signs
    T sine(-1.0 / 1307674368000.0), cosine(1.0 / 20922789888000.0);
    for (const double c :
         {1.0 / 6227020800.0, -1.0 / 39916800.0, 1.0 / 362880.0, -1.0 / 5040.0, 1.0 / 120.0, -1.0 / 6.0})
        sine = sine * z + T(c);
    for (const double c :
         {-1.0 / 87178291200.0, 1.0 / 479001600.0, -1.0 / 3628800.0, 1.0 / 40320.0, -1.0 / 720.0, 1.0 / 24.0, -0.5})
        cosine = cosine * z + T(c);
    const auto upright = (quarter == T(1.0)) | (quarter == T(3.0)), below = (quarter == T(2.0)) | (quarter == T(3.0));
    const T size = select(upright, T(1.0) + z * cosine, x + x * z * sine);
    return select(below, -size, size);
}

/// sin(2 pi v), by way of the fraction: to the last bit, as POV-Ray's. Ripples in glass make another one visible.
inline double cycle(double v)
{
    return v >= 0.0 ? numbers::sin(kTau * (v - std::floor(v))) : -numbers::sin(kTau * (-v - std::floor(-v)));
}

/// The same by turn_sine(), for colours.
inline double series_cycle(double v)
{
    const double size = std::abs(v),
                 s = turn_sine(size - std::floor(size), [](bool where, double a, double b) { return where ? a : b; });
    return v >= 0.0 ? s : -s;
}

}  // namespace texture
