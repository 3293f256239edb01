#include "numbers/functions/functions.h"
#include "render/texture/points/angle.h"
#include "render/texture/noise/noise.h"
#include "render/texture/noise/noise_points.h"
#include "render/texture/patterns/patterns.h"
#include "render/texture/patterns/turning.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace texture {
namespace {

double turbulence_at(const Pattern& pattern, const glm::dvec3& p)
{
    const scene::Turbulence& t = pattern.turbulence;
    return scalar_turbulence(p, t.octaves, t.lambda, t.omega, pattern.noise_generator);
}

/// With the turbulence where the pattern has one.
double turbulent_spiral(const Pattern& pattern, const glm::dvec3& p)
{
    const double base = spiral_phase(std::trunc(pattern.numbers[0]), p.x, p.y, p.z);
    return pattern.has_turbulence ? base + pattern.turbulence.amount.x * turbulence_at(pattern, p) : base;
}

}  // namespace

double bozo(const Pattern& pattern, const glm::dvec3& p) { return noise(p, pattern.noise_generator); }

double dents(const Pattern& pattern, const glm::dvec3& p)
{
    const double n = noise(p, pattern.noise_generator);
    return n * n * n;
}

double granite(const Pattern& pattern, const glm::dvec3& p)
{
    return octaves_at(p, OctaveSum::Granite, pattern.noise_generator);
}

double wrinkles(const Pattern& pattern, const glm::dvec3& p)
{
    return octaves_at(p, OctaveSum::Wrinkles, pattern.noise_generator);
}

double agate(const Pattern& pattern, const glm::dvec3& p)
{
    return agate_band(pattern, p.z, turbulence_at(pattern, p));
}

double agate_band(const Pattern& pattern, double z, double turbulence)
{
    return agate_power((1.0 + series_cycle(1.3 * pattern.numbers[0] * turbulence + 1.1 * z)) / 2.0);
}

double marble(const Pattern& pattern, const glm::dvec3& p)
{
    return pattern.has_turbulence ? p.x + pattern.turbulence.amount.x * turbulence_at(pattern, p) : p.x;
}

double wood(const Pattern& pattern, const glm::dvec3& p)
{
    if (!pattern.has_turbulence) return std::sqrt(p.x * p.x + p.y * p.y);
    const scene::Turbulence& t = pattern.turbulence;
    const glm::dvec3 d = vector_turbulence(p, t.octaves, t.lambda, t.omega);
    return wood_ring(pattern, p.x, p.y, d.x, d.y);
}

double wood_ring(const Pattern& pattern, double px, double py, double dx, double dy)
{
    const double x = px + series_cycle((px + dx) * pattern.turbulence.amount.x);
    const double y = py + series_cycle((py + dy) * pattern.turbulence.amount.y);
    return std::sqrt(x * x + y * y);
}

double spiral1(const Pattern& pattern, const glm::dvec3& p) { return turbulent_spiral(pattern, p); }

double spiral2(const Pattern& pattern, const glm::dvec3& p)
{
    return triangle(spiral_radius(p.x, p.y)) + triangle(turbulent_spiral(pattern, p));
}

}  // namespace texture
