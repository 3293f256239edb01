#pragma once

#include "numbers/lanes.h"

#include <algorithm>
#include <cmath>

/// Fresnel's equations for one ray and for many. Compiled once per instruction set.
namespace texture {

/// Share of the maximum at an angle, by Fresnel's equations; 1 beyond the critical angle.
inline double fresnel_share(double eta, double c)
{
    const double q = eta * eta + c * c - 1.0;
    if (q <= 0.0) return 1.0;
    const double g = std::sqrt(q);
    const double a = (g - c) / (g + c);
    const double b = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
    return std::clamp(0.5 * a * a * (1.0 + b * b), 0.0, 1.0);
}

/// The same to the last bit.
inline csg::lanes::Double fresnel_share(const csg::lanes::Double& eta, const csg::lanes::Double& c)
{
    using csg::lanes::Double;
    const Double zero(0.0), one(1.0);
    const Double q = eta * eta + c * c - one, g = xsimd::sqrt(q);
    const Double a = (g - c) / (g + c);
    const Double b = (c * (g + c) - one) / (c * (g - c) + one);
    const Double share = Double(0.5) * a * a * (one + b * b);
    return xsimd::select(q <= zero, one, xsimd::select(share < zero, zero, xsimd::select(one < share, one, share)));
}

}  // namespace texture
