#pragma once

#include "csg/base/fused_at.h"
#include "csg/freeform/shared/intersection_list.h"
#include "numbers/lane_arithmetic.h"

#include <algorithm>
#include <cmath>

/// Where a ray is marched through a julia fractal: shared by one ray and by rays in lanes.
namespace csg::julia {

inline constexpr double kNearest =
    1e-7;  // depth of the first look and of a crossing's last interval, local (spec 5b, 12.2)
// Of a set so large that kNearest is more than this in the world, a crossing is closed in on as far, or until the
// digits end: else rays would meet their own start.
inline constexpr double kFinest = 1e-5, kLeast = 1e-15;
inline constexpr double kUnit = 1e-15;  // a direction whose length is as near to 1 is taken as it is
inline constexpr double kLeastSlope = -1e-8, kLeastGuess = 1.0, kMostGuess = 30.0;

/// The step that follows from how the size of an orbit's last point grows along the ray; `least` where that tells
/// little.
template <class V>
inline V guessed_step(const V& size, const V& growth, const V& least)
{
    const V fall = -2.0 * growth;
    const lanes::Truth<V> tells = (growth < V(kLeastSlope)) & (size > kLeastGuess * least * fall) &
                                  (size < kMostGuess * least * fall);
    return lanes::choose(tells, size / fall, least);
}

/// From far away the steps would be shorter than the last digit of the parameter: such a ray is taken from beside the
/// set, to which it is moved with one rounding. How far along it that is.
inline double move_near(double radius, Ray& ray)
{
    constexpr double kManyRadii = 1e5;  // of the radius: 1e-11 of it is left
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
    bool meets = false;

    Way() = default;
    Way(const Ray& ray, double radius, const IntersectionList& asked)
        : unit(ray), length(std::sqrt(glm::dot(ray.direction, ray.direction)))
    {
        if (std::abs(length - 1.0) < kUnit) length = 1.0;
        unit.direction = ray.direction / length;
        start = move_near(radius, unit);
        // Whether a ray that comes in on the set finds it there is a matter of the last bit: this is POV-Ray's formula.
        const double foot = -glm::dot(unit.origin, unit.direction),
                     rest = foot * foot - (glm::dot(unit.origin, unit.origin) - radius * radius);
        entry = foot - std::sqrt(rest);
        exit = foot + std::sqrt(rest);
        meets = rest > 0.0 && !(exit < kNearest - start) && !(exit < asked.from * length - start);
        if (!meets) return;
        begin = std::max(entry, kNearest - start);
        end = std::min(exit, asked.to * length - start);
        nearest = glm::clamp(kFinest * length, kLeast, kNearest);
    }

    /// In the given ray's parameter.
    double world(double t) const { return (start + t) / length; }
    double world(double t, double step) const { return (start + t + step) / length; }
};

/// A ray on its way: one look after the other, where it is wanted().
struct March {
    enum class Phase : std::uint8_t { First, Second, Stepping, Halving };

    Way way;
    IntersectionList* out = nullptr;
    double t = 0.0, step = 0.0;  ///< step: to the next look, or half of the interval
    double same = 0.0;           ///< still as at t: begin of the interval
    double behind = 0.0;         ///< where the step led that found a change
    double step_behind = 0.0;    ///< what the look there gave
    Phase phase = Phase::First;
    bool inside = false, inside_behind = false;  ///< at t; behind the change

    March() = default;
    March(const Way& through, IntersectionList& told) : way(through), out(&told), t(through.begin) {}

    double wanted() const { return phase == Phase::Stepping ? t + step : phase == Phase::Halving ? same + step : t; }

    /// What follows from a look: whether it was inside, and the step that it gave. False: the ray is done.
    /// \param least  no step is shorter
    bool settle(bool in, double found, double least)
    {
        switch (phase) {
        case Phase::Stepping:
            if (in == inside) {
                t += step;
                return march_on(found, least);
            }
            same = t;
            behind = t + step;
            inside_behind = in;
            step_behind = found;
            phase = Phase::Halving;
            return halve(least);
        case Phase::Halving:
            if (in == inside) same += step;
            return halve(least);
        case Phase::First:
            if (in) {  // once more, a little farther on
                t += 2.0 * kNearest;
                phase = Phase::Second;
                return true;
            }
            [[fallthrough]];
        case Phase::Second:
            inside = in;
            return (!in || out->enter(way.world(way.entry), kUndrawnFace)) && march_on(found, least);
        }
        return false;
    }

private:
    bool march_on(double found, double least)
    {
        step = std::max(found, least);
        phase = Phase::Stepping;
        if (step < kInfinity && t + step <= way.end) return true;
        if (inside) out->leave(way.world(way.exit), kUndrawnFace);
        return false;
    }

    /// To the next half, or, where the interval is as short as it has to be, over the crossing.
    bool halve(double least)
    {
        if (step > way.nearest) {
            step *= 0.5;
            return true;
        }
        const bool more = inside ? out->leave(way.world(same), 0) : out->enter(way.world(same, step), 0);
        if (!more || out->first_only) return false;  // POV-Ray looks no farther, though it may be too near to count
        t = behind;
        inside = inside_behind;
        return march_on(step_behind, least);
    }
};

}  // namespace csg::julia
