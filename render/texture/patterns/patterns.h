#pragma once

#include "numbers/lane_power.h"
#include "render/texture/evaluate.h"
#include "render/texture/points/points.h"

#include <cmath>

/// Raw values of the patterns, one function each, by family. Formulas and ranges: spec 4, section 5.
/// `p` is the warped point; parameters as in docs/patterns.md.
namespace texture {

// looked up
/// numbers: interpolate.
double density(const Pattern& pattern, const scene::Volume& volume, const glm::dvec3& p);
void density_values(const Pattern& pattern, const scene::Volume& volume, const Points& p, Values& out);

/// A pattern by a user function.
void function_values(const TextureSet& set, const Pattern& pattern, const Points& p, Values& out);
/// A colour's components by functions, 0 where there is none.
void function_colors(const TextureSet& set, const ColorFunctions& functions, const Points& p, ColorPoints& out);

/// A field at a point (spec 7b, 3). numbers: whether the threshold is taken off.
double potential(const Potential& of, const Pattern& pattern, const glm::dvec3& p);
void potential_values(const Potential& of, const Pattern& pattern, const Points& p, Values& out);

/// What a user function tells: above 1 it counts from 0 again (spec 4, 5.2). v - trunc(v) is fmod(v, 1), to the bit.
inline double wrapped_value(double v) { return v > 1.0 ? v - std::trunc(v) : v; }

// noise based
double bozo(const Pattern& pattern, const glm::dvec3& p);
double dents(const Pattern& pattern, const glm::dvec3& p);
double granite(const Pattern& pattern, const glm::dvec3& p);
double wrinkles(const Pattern& pattern, const glm::dvec3& p);
double agate(const Pattern& pattern, const glm::dvec3& p);
double marble(const Pattern& pattern, const glm::dvec3& p);
double wood(const Pattern& pattern, const glm::dvec3& p);
/// agate from its turbulence, or from the sine that this becomes, 0 to 1 (T: a number or vector lanes); and wood moved
/// by (dx, dy).
double agate_band(const Pattern& pattern, double z, double turbulence);
template <class T>
inline T agate_power(const T& c)
{
    using numbers::lanes::choose;
    const T zero(0.0), one(1.0), held = choose(c < one, c, one);
    return choose(held > zero, numbers::lanes::power(choose(held > zero, held, one), T(0.77)), zero);
}
double wood_ring(const Pattern& pattern, double px, double py, double dx, double dy);
double spiral1(const Pattern& pattern, const glm::dvec3& p);
double spiral2(const Pattern& pattern, const glm::dvec3& p);

// geometric
double boxed(const glm::dvec3& p);
double spherical(const glm::dvec3& p);
double cylindrical(const glm::dvec3& p);
double planar(const glm::dvec3& p);
double gradient(const Pattern& pattern, const glm::dvec3& p);
double onion(const glm::dvec3& p);
double radial(const glm::dvec3& p);
double leopard(const glm::dvec3& p);
double cells(const glm::dvec3& p);
double quilted(const Pattern& pattern, const glm::dvec3& p);
double ripples(const TextureSet& set, const Pattern& pattern, const glm::dvec3& p);
double waves(const TextureSet& set, const Pattern& pattern, const glm::dvec3& p);
/// The same of each point; padded.
void radial_values(const Points& p, Values& out);
void quilted_values(const Pattern& pattern, const Points& p, Values& out);
void leopard_values(const Points& p, Values& out);
void ripples_values(const TextureSet& set, const Pattern& pattern, const Points& p, Values& out);
void waves_values(const TextureSet& set, const Pattern& pattern, const Points& p, Values& out);
double aoi(const Surroundings& around);
double slope(const Pattern& pattern, const glm::dvec3& p, const Surroundings& around);

// integer valued
double checker(const glm::dvec3& p);
double brick(const Pattern& pattern, const glm::dvec3& p);
double hexagon(const glm::dvec3& p);
double square(const glm::dvec3& p);
double cubic(const glm::dvec3& p);
double triangular(const glm::dvec3& p);

// tilings of the x-z plane: greatest at the edges of the tiles
double tiling(const Pattern& pattern, const glm::dvec3& p);
double pavement(const Pattern& pattern, const glm::dvec3& p);

double crackle(const Pattern& pattern, const glm::dvec3& p);
/// crackle of each point; padded.
void crackle_values(const Pattern& pattern, const Points& p, Values& out);

/// mandel, julia and the magnets.
double fractal(const Pattern& pattern, const glm::dvec3& p);
/// fractal of each point; padded.
void fractal_values(const Pattern& pattern, const Points& p, Values& out);

}  // namespace texture
