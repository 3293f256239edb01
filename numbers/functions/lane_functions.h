#pragma once

#include "numbers/functions/functions.h"
#include "numbers/lanes.h"

/// The functions of numbers in lanes, with the bits that each has alone.
namespace numbers {

using lanes::Double;

Double sin(const Double& x);
Double cos(const Double& x);
Double tan(const Double& x);
Double asin(const Double& x);
Double acos(const Double& x);
Double atan(const Double& x);
Double atan2(const Double& y, const Double& x);
Double exp(const Double& x);
Double log(const Double& x);
Double log10(const Double& x);
Double pow(const Double& x, const Double& y);
Double sinh(const Double& x);
Double cosh(const Double& x);
Double tanh(const Double& x);
Double asinh(const Double& x);
Double acosh(const Double& x);
Double atanh(const Double& x);
Double hypot(const Double& x, const Double& y);
SineAndCosine<Double> sine_and_cosine(const Double& x);
SineAndCosine<Double> hyperbolic(const Double& x);

}  // namespace numbers
