#pragma once

#include "numbers/lanes.h"

#include <cstdint>

/// Powers in lanes of single precision, for what is only compared with a threshold.
namespace numbers {

using lanes::FloatPart;
using lanes::kFloatPart;

/// c^n for 1e-30 <= c <= 256 and 0 < n <= 3, with a relative error below 1.5e-6. Results below 2^-120 become 2^-120.
inline FloatPart float_power(const FloatPart& c, const FloatPart& n)
{
    using Integers = xsimd::as_integer_t<FloatPart>;
    constexpr std::int32_t kOne = 0x3f800000, kRoot = 0x3f3504f3;  // 1 and the root of 1/2
    const Integers bits = lanes::same_bits<Integers>(c), steps = (bits + Integers(kOne - kRoot)) >> 23;
    const FloatPart e = xsimd::to_float(steps - Integers(127));
    const FloatPart m = lanes::same_bits<FloatPart>(bits - ((steps - Integers(127)) << 23));
    // log2 m = 2 artanh((m - 1) / (m + 1)) / ln 2 by its series: m lies between the roots of 1/2 and 2.
    const FloatPart f = (m - FloatPart(1.0f)) / (m + FloatPart(1.0f)), s = f * f;
    const FloatPart odd =
        FloatPart(2.88539008f) +
        s * (FloatPart(0.961796694f) +
             s * (FloatPart(0.577078016f) + s * (FloatPart(0.412198583f) + s * FloatPart(0.320598898f))));
    FloatPart y = n * (e + f * odd);
    y = xsimd::select(y > FloatPart(-120.0f), y, FloatPart(-120.0f));
    constexpr float kRound = 12582912.0f;  // 1.5 2^23: what is added to it loses its fraction
    const FloatPart shifted = y + FloatPart(kRound), r = y - (shifted - FloatPart(kRound));
    // 2^r by its series
    const FloatPart low = FloatPart(1.0f) +
                          r * (FloatPart(0.693147181f) + r * (FloatPart(0.240226507f) + r * FloatPart(0.0555041087f)));
    const FloatPart high = FloatPart(0.00961812911f) + r * (FloatPart(0.00133335581f) + r * FloatPart(0.000154035304f));
    const FloatPart squared = r * r, power = low + squared * squared * high;
    return lanes::same_bits<FloatPart>(lanes::same_bits<Integers>(power) + (lanes::same_bits<Integers>(shifted) << 23));
}

}  // namespace numbers
