#pragma once

#include "numbers/lane_arithmetic.h"
#include "numbers/remainder.h"

namespace numbers {

/// fmod() of each, to the bit.
inline lanes::Double fmod(const lanes::Double& a, const lanes::Double& b)
{
    using lanes::Double;
#if defined(__FMA__)
    const Double most(0x1p52), size = xsimd::abs(a), by = xsimd::abs(b), quotient = xsimd::trunc(size / by),
                               rest = lanes::fused_rest(size, quotient, by);
    if (lanes::mask((quotient < most) & (by < most)) == (1u << lanes::kDoubles) - 1)
        return lanes::signed_as(xsimd::select(rest < Double(0.0), rest + by, rest), a);
#endif
    alignas(64) std::array<double, static_cast<std::size_t>(lanes::kDoubles)> x, y;
    a.store_aligned(x.data());
    b.store_aligned(y.data());
    for (std::size_t k = 0; k < x.size(); ++k) x[k] = fmod(x[k], y[k]);
    return Double::load_aligned(x.data());
}

}  // namespace numbers
