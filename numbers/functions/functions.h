#pragma once

#include <cmath>

/// The C library's functions, and its values in special cases, with the same bits on every machine and within 0.52
/// units in the last place (docs/numerics.md). std:: has those that are exact: sqrt, fma, fmod, floor, ldexp, ...
namespace numbers {

double sin(double x);
double cos(double x);
double tan(double x);
double asin(double x);
double acos(double x);
double atan(double x);
double atan2(double y, double x);
double exp(double x);
double log(double x);
double log2(double x);
double log10(double x);
double pow(double x, double y);
double sinh(double x);
double cosh(double x);
double tanh(double x);
double asinh(double x);
double acosh(double x);
double atanh(double x);
double hypot(double x, double y);

double hypot(double x, double y, double z);

/// Of one number, or the hyperbolic ones: together they take little longer than one.
template <class V>
struct SineAndCosine {
    V sine, cosine;
};
SineAndCosine<double> sine_and_cosine(double x);
SineAndCosine<double> hyperbolic(double x);

float exp(float x);
float pow(float x, float y);
float hypot(float x, float y);

}  // namespace numbers
