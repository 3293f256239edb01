#pragma once

#include "render/trace/radiosity/field.h"
#include "render/trace/radiosity/gather_scratch.h"

#include <cmath>

/// Which samples a point may use, and how much they count (spec 6, 4.5).
namespace trace::radiosity {

/// A point that asks.
struct Query {
    glm::dvec3 point, normal;
    double bound;  ///< of the error
    bool smooth;   ///< weights fade smoothly: in the picture, and for what the camera sees
};

/// Weight of a sample, its quality included; 0: of no use.
inline double weight_of(const Sample& s, const Query& q)
{
    constexpr double kSame = 1e-6, kLeast = 0.001, kBehind = -0.05;
    const glm::dvec3 v = q.point - s.point, n(s.normal);
    const double d = glm::length(v), reach = static_cast<double>(s.reach);
    if (!(d < reach * q.bound)) return 0.0;
    double r = reach, front = 1.0;
    if (d > kSame) {
        const double toward = glm::dot(glm::dvec3(s.nearest_way), v) / d;
        if (toward > 0.0) {
            r = toward * static_cast<double>(s.nearest) + (1.0 - toward) * reach;
            if (!(d < r * q.bound)) return 0.0;
        }
        const glm::dvec3 mean = q.normal + n;
        front = glm::dot(v, mean) / (d * glm::length(mean));
    }
    const double error = d / r + 2.0 * std::sqrt(std::abs(1.0 - glm::dot(q.normal, n)));
    if (!(error < q.bound) || !(front > kBehind)) return 0.0;
    const double x = error / q.bound;
    double weight = !q.smooth ? 1.0 - x : x < 0.5 ? 1.0 - 2.0 * x * x : 2.0 * (1.0 - x) * (1.0 - x);
    if (front <= 0.0) weight *= 1.0 + 20.0 * front;
    return weight > kLeast ? weight * static_cast<double>(s.quality) : 0.0;
}

inline void use(const Sample& s, const Query& q, Lookup& to)
{
    const double w = weight_of(s, q);
    if (w == 0.0) return;
    to.weight += w;
    to.sum += w * glm::dvec3(s.color);
}

/// Adds all samples of `grid` that the point may use.
inline void look_up(const SampleGrid& grid, const Query& q, Lookup& to)
{
    grid.visit(q.point, q.bound, [&](const Sample& s) { use(s, q, to); });
}

}  // namespace trace::radiosity
