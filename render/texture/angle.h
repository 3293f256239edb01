#pragma once

#include <cmath>
#include <numbers>

/// Small functions that several patterns and warps share (spec 4, sections 4 and 8.2).
namespace texture {

inline constexpr double kTiny = 1e-10;  ///< the "small number" of the pattern formulas
inline constexpr double kTau = 2.0 * std::numbers::pi;

/// Counter-clockwise from +x toward +z, 0 to 1.
inline double turn(double x, double z)
{
    if (z == 0.0) return x > 0.0 ? 0.0 : 0.5;
    const double a = std::acos(x / std::sqrt(x * x + z * z)) / kTau;
    return z < 0.0 ? 1.0 - a : a;
}

/// sin(2 pi v), by way of the fraction.
inline double cycle(double v)
{
    return v >= 0.0 ? std::sin(kTau * (v - std::floor(v))) : -std::sin(kTau * (-v - std::floor(-v)));
}

/// 0 to 1 and back over one unit.
inline double triangle(double v)
{
    const double o = v >= 0.0 ? v - std::floor(v) : v + 1.0 + std::floor(std::abs(v));
    return o < 0.5 ? 2.0 * o : 2.0 * (1.0 - o);
}

}  // namespace texture
