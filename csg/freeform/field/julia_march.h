#pragma once

#include "csg/freeform/shared/intersection_list.h"
#include "csg/base/fused_at.h"

#include <algorithm>
#include <cmath>

/// Where a ray is marched through a julia fractal: shared by one ray and by rays in lanes.
namespace csg::julia {

inline constexpr double kNearest =
    1e-7;  // depth of the first look and of a crossing's last interval, local (spec 5b, 12.2)
// Of a set so large that kNearest is more than this in the world, a crossing is closed in on as far, or until the
// digits end: else rays would meet their own start.
inline constexpr double kFinest = 1e-5, kLeast = 1e-15;
inline constexpr double kManyRadii = 1e5;  // so far away 1e-11 of the radius is left
inline constexpr double kUnit = 1e-15;     // a direction of the world whose length is as near to 1 is taken as it is
inline constexpr double kLeastSlope = -1e-8, kLeastGuess = 1.0, kMostGuess = 30.0;

/// From far away the steps would be shorter than the last digit of the parameter: such a ray is taken from beside the
/// set, to which it is moved with one rounding. How far along it that is.
inline double move_near(double radius, Ray& ray)
{
    if (!(glm::dot(ray.origin, ray.origin) > kManyRadii * kManyRadii * radius * radius)) return 0.0;
    const double t = -glm::dot(ray.origin, ray.direction);
    if (!(std::abs(t) < kInfinity)) return 0.0;
    ray.origin = fused_at(ray, t);
    return t;
}

/// A ray's way through the sphere that holds the set, by length from its start or, from far away, from beside the set.
struct Way {
    Ray unit;
    double length = 1.0, start = 0.0;              ///< of the direction given; of `unit` along the ray
    double entry = 0.0, exit = 0.0;                ///< of the sphere
    double begin = 0.0, end = 0.0, nearest = 0.0;  ///< first look, last look, last interval of a crossing
    double last = kInfinity;                       ///< from no farther place one looks on
    bool meets = false;

    Way() = default;
    /// `moved`: through a transformation, as in Julia::intersect(); `beyond`: unless JuliaTerms::as_37.
    Way(const Ray& ray, bool moved, bool beyond, double radius, const IntersectionList& asked)
        : unit(ray), length(std::sqrt(glm::dot(ray.direction, ray.direction)))
    {
        if (!moved && std::abs(length - 1.0) < kUnit) length = 1.0;
        unit.direction = ray.direction * (1.0 / length);
        start = move_near(radius, unit);
        // Whether a ray that comes in on the set finds it there is a matter of the last bit: this is POV-Ray's formula.
        const double foot = -glm::dot(unit.origin, unit.direction),
                     rest = foot * foot - (glm::dot(unit.origin, unit.origin) - radius * radius);
        entry = foot - std::sqrt(rest);
        exit = foot + std::sqrt(rest);
        meets = rest > 0.0 && !(exit < kNearest - start) && !(exit < asked.from * length - start);
        if (!meets) return;
        begin = std::max(entry, kNearest - start);
        const double to = asked.to * length - start;
        end = beyond ? exit : std::min(exit, to);
        if (beyond) last = to;
        nearest = glm::clamp(kFinest * length, kLeast, kNearest);
    }

    /// Whether a step from t ends in another look.
    bool goes_on(double t, double step) const { return step < kInfinity && t <= last && t + step <= end; }
    /// In the given ray's parameter.
    double world(double t) const { return (start + t) / length; }
    double world(double t, double step) const { return (start + t + step) / length; }
};

}  // namespace csg::julia
