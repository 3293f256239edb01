#include "numbers/functions/functions.h"
#include "numbers/remainder.h"
#include "numbers/rounding.h"
#include "render/texture/points/angle.h"
#include "render/texture/noise/noise.h"
#include "render/texture/patterns/patterns.h"
#include "render/texture/patterns/turning.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace texture {
namespace {

double inside_out(double distance) { return distance > 1.0 ? 0.0 : 1.0 - distance; }

/// Applies the range [low, high] of a slope; none given: unchanged.
double ranged(double v, double low, double high)
{
    if (low == high) return v;
    return (v - low) / (high - low);
}

}  // namespace

double boxed(const glm::dvec3& p) { return inside_out(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)})); }

double spherical(const glm::dvec3& p) { return inside_out(glm::length(p)); }

double cylindrical(const glm::dvec3& p) { return inside_out(std::sqrt(p.x * p.x + p.z * p.z)); }

double planar(const glm::dvec3& p) { return inside_out(std::abs(p.y)); }

double gradient(const Pattern& pattern, const glm::dvec3& p)
{
    const double d = glm::dot(p, pattern.vector);
    return d > 1.0 ? numbers::fmod(d, 1.0) : d;
}

double onion(const glm::dvec3& p) { return numbers::fmod(glm::length(p), 1.0); }

double radial(const glm::dvec3& p) { return radial(p.x, p.z); }

double leopard(const glm::dvec3& p)
{
    const double s = (numbers::sin(p.x) + numbers::sin(p.y) + numbers::sin(p.z)) / 3.0;
    return s * s;
}

double cells(const glm::dvec3& p)
{
    const glm::dvec3 cell = glm::floor(p + kTiny);
    return pattern_random(
        cell_hash(numbers::truncated_far(cell.x), numbers::truncated_far(cell.y), numbers::truncated_far(cell.z)));
}

double quilted(const Pattern& pattern, const glm::dvec3& p)
{
    return quilted(p.x, p.y, p.z, pattern.numbers[0], pattern.numbers[1]);
}

double ripples(const TextureSet& set, const Pattern& pattern, const glm::dvec3& p)
{
    double sum = 0.0;
    for (const glm::dvec3& source : set.wave_sources) {
        const double l = glm::length(p - source);
        sum += cycle((l == 0.0 ? 1.0 : l) * pattern.frequency + pattern.phase);
    }
    return 0.5 * (1.0 + sum / static_cast<double>(set.wave_sources.size()));
}

double waves(const TextureSet& set, const Pattern& pattern, const glm::dvec3& p)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < set.wave_sources.size(); ++i) {
        const double l = glm::length(p - set.wave_sources[i]);
        const double f = set.wave_frequencies[i];
        sum += cycle((l == 0.0 ? 1.0 : l) * pattern.frequency * f + pattern.phase) / f;
    }
    return 0.2 * (2.5 + sum / static_cast<double>(set.wave_sources.size()));
}

double aoi(const Surroundings& around)
{
    if (!around.surface) return 0.0;
    // The angle itself, also where no_bump_scale leaves the normal longer or shorter; slope takes it as it is.
    const double cosine = glm::dot(around.normal, around.direction) / glm::length(around.normal);
    return numbers::acos(std::clamp(cosine, -1.0, 1.0)) / std::numbers::pi;
}

/// numbers: low, high, point_at, altitude x, y, z, its low and high.
double slope(const Pattern& pattern, const glm::dvec3& p, const Surroundings& around)
{
    if (!around.surface) return 0.0;
    const auto& n = pattern.numbers;
    const glm::dvec3 toward = n[2] != 0.0 ? pattern.vector - around.point : pattern.vector;
    const double s = std::clamp(glm::dot(around.normal, glm::normalize(toward)), -1.0, 1.0);
    const double v1 = ranged((2.0 * numbers::asin(s) / std::numbers::pi + 1.0) / 2.0, n[0], n[1]);
    const glm::dvec3 altitude{n[3], n[4], n[5]};
    const auto wrapped = [](double v) {
        const double w = numbers::fmod(v, 1.0);
        return v < 0.0 ? w + 1.0 : w;
    };
    if (altitude == glm::dvec3(0)) return v1 == 1.0 ? v1 - kTiny : wrapped(v1);
    const double height = glm::length(altitude), steepness = glm::length(pattern.vector);
    const double v2 = ranged(glm::dot(p, altitude) / height, n[6], n[7]);
    const double weight = steepness / (steepness + height);
    const double v = weight * v1 + (1.0 - weight) * v2;
    return v >= 1.0 && v < 1.0 + kTiny ? v - kTiny : wrapped(v);
}

}  // namespace texture
