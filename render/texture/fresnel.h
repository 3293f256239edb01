#pragma once

#include "numbers/lane_power.h"

/// Fresnel's equations, for one ray (double) and for many (numbers::lanes::Double): the same bits.
namespace texture {

/// Share of unpolarised light that a smooth boundary mirrors; 1 beyond the critical angle.
/// \param eta  index behind the boundary over that on this side
/// \param c    cosine of the angle of incidence
template <class T>
inline T fresnel_share(const T& eta, const T& c)
{
    using numbers::lanes::choose;
    const T zero(0.0), one(1.0), q = eta * eta + c * c - one, g = numbers::lanes::root_of(q);
    const T a = (g - c) / (g + c);
    const T b = (c * (g + c) - one) / (c * (g - c) + one);
    const T share = T(0.5) * a * a * (one + b * b);
    return choose(q <= zero, one, choose(share < zero, zero, choose(one < share, one, share)));
}

}  // namespace texture
