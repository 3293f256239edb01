#pragma once

#include "function/arithmetic.h"
#include "function/interval.h"

/// Operators and built-in functions over intervals.
namespace function {

Interval interval_binary(Op op, const Interval& a, const Interval& b);
Interval interval_unary(Op op, const Interval& a);

/// [a, b] with room for the error of the C library; everything if an end is no number.
Interval widened(double low, double high);

}  // namespace function
