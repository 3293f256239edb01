#pragma once

#include "function/points/batch.h"

#include <numbers>

/// Sine and arc tangent in vector lanes, to ten digits: enough for the ends of intervals, which are widened by more.
namespace function {

inline constexpr double kAngleError = 1e-10;  ///< of both, generously, where the argument is as they say

/// Of the polynomial with these coefficients, the highest first.
template <std::size_t N>
inline Batch polynomial_of(const Batch& v, const double (&coefficients)[N])
{
    Batch sum(coefficients[0]);
    for (std::size_t i = 1; i < N; ++i) sum = sum * v + Batch(coefficients[i]);
    return sum;
}

/// sin(2 pi turn); |turn| below 2e5.
inline Batch sine_of_turn(const Batch& turn)
{
    const Batch half(0.5), quarter(0.25), part = turn - xsimd::floor(turn + half);  // -0.5 to 0.5
    const Batch folded = xsimd::select(part > quarter, half - part, xsimd::select(part < -quarter, -half - part, part)),
                angle = folded * Batch(2.0 * std::numbers::pi);
    // The series of the sine; what is left out is below 6e-12 at a quarter turn.
    static constexpr double kSeries[] = {-1.0 / 1307674368000.0, 1.0 / 6227020800.0, -1.0 / 39916800.0, 1.0 / 362880.0,
                                         -1.0 / 5040.0,          1.0 / 120.0,        -1.0 / 6.0,        1.0};
    return angle * polynomial_of(angle * angle, kSeries);
}

/// atan2(y, x), but on the negative x axis either of its two values; no number where both are 0 or infinite.
inline Batch angle_of(const Batch& y, const Batch& x)
{
    const Batch zero(0.0), one(1.0), ay = xsimd::abs(y), ax = xsimd::abs(x);
    const auto steep = ay > ax;
    const Batch slope = xsimd::select(steep, ax, ay) / xsimd::select(steep, ay, ax);  // 0 to 1
    // Above tan(pi / 8) the angle is told from pi / 4.
    const auto large = slope > Batch(0.41421356237309503);
    const Batch t = xsimd::select(large, (slope - one) / (slope + one), slope);
    // The series of the arc tangent; what is left out is below 2e-11.
    static constexpr double kSeries[] = {-1.0 / 23.0, 1.0 / 21.0, -1.0 / 19.0, 1.0 / 17.0, -1.0 / 15.0, 1.0 / 13.0,
                                         -1.0 / 11.0, 1.0 / 9.0,  -1.0 / 7.0,  1.0 / 5.0,  -1.0 / 3.0,  1.0};
    const Batch angle = t * polynomial_of(t * t, kSeries) + xsimd::select(large, Batch(std::numbers::pi / 4), zero);
    const Batch first = xsimd::select(steep, Batch(std::numbers::pi / 2) - angle, angle),
                upper = xsimd::select(x < zero, Batch(std::numbers::pi) - first, first);
    return xsimd::select(y < zero, -upper, upper);
}

}  // namespace function
