#pragma once

#include "function/program.h"
#include "numbers/functions/functions.h"


/// Internal functions that are no polynomials. a: x, y, z, then the parameters (spec 5b, 16).
namespace function {

double blob(const double* a);
double blob2(const double* a);
double comma(const double* a);
double ellipsoids(std::uint32_t n, const double* a);  ///< 10 crossed, 19 flange cover, 32 intersection
double ellipsoid(const double* a);
double enneper(const double* a);
/// With the terms of the surface's equation that POV-Ray 3.7 leaves out (spec 7c, 9).
double whole_enneper(const double* a);
double helical_torus(const double* a);
double helix1(const double* a);
double helix2(const double* a);
double hexagonal(bool y, const double* a);
double mesh1(const double* a);
double poly4(const double* a);
double polytubes(const double* a);
double quantum(const double* a);
double rounded_box(const double* a);
double spikes(const double* a);
double spiral(const double* a);
double superellipsoid(const double* a);
double torus(const double* a);

inline constexpr double kMostOctaves = 1000.0;  ///< a scene that asks for 1e9 must not hang
double hetero_mf(const double* a, const Host& host);
/// What an octave of f_hetero_mf counts for more where the sum of those before is great: sum^power, power a whole
/// number that is mostly 1 or 2.
inline double hetero_gain(double sum, double power)
{
    return power == 1.0 ? sum : power == 2.0 ? sum * sum : numbers::pow(sum, power);
}
double ridge(const double* a, const Host& host);
double ridged_mf(const double* a, const Host& host, const double* weights);
/// Noise generator 1 to 3 as a parameter says: its lowest two bits, 0 counting as 1.
int generator(double parameter);

}  // namespace function
