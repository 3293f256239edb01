#pragma once

#include "function/arithmetic.h"
#include "function/intervals/interval.h"

/// Operators and built-in functions over intervals.
namespace function {

inline constexpr double kRelative =
    1e-15;  ///< above the error of one operation or library function, 4 units in the last place
inline constexpr double kAbsolute = 1e-300;  ///< the same next to 0
inline constexpr double kInf = std::numeric_limits<double>::infinity();

Interval interval_binary(Op op, const Interval& a, const Interval& b);
Interval interval_unary(Op op, const Interval& a);

Interval absolute(const Interval& a);
inline Interval larger(const Interval& a, const Interval& b)
{
    return {std::max(a.low, b.low), std::max(a.high, b.high)};
}

/// [a, b] with room for the error of the C library; everything if an end is no number.
Interval widened(double low, double high);

}  // namespace function
