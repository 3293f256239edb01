#pragma once

#include "csg/tree/program.h"
#include "tests/support/share.h"

#include <cmath>
#include <cstdint>
#include <random>

namespace csg_test {

using test::share;

/// Numbers that are the same on every machine: only the engine is used, not the library's distributions.
class Rng {
public:
    explicit Rng(std::uint32_t seed) : engine_(seed) {}
    double uniform(double lo, double hi) { return lo + (hi - lo) * (static_cast<double>(engine_()) / 4294967296.0); }
    int below(int n) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(n)); }
    bool coin() { return below(2) == 0; }
    glm::dvec3 point(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }
    glm::dvec3 direction()
    {
        for (;;) {
            const glm::dvec3 p = point(1.0);
            const double l = glm::length(p);
            if (l > 0.1 && l < 1.0) return p / l;
        }
    }

private:
    std::mt19937 engine_;
};

/// Rays that start `distance` away and pass within `size` of `target`.
inline csg::Ray ray_near(Rng& rng, const glm::dvec3& target, double size, double distance)
{
    const glm::dvec3 origin = target + rng.direction() * distance;
    return {origin, glm::normalize(target + rng.point(size) - origin)};
}

/// A ray whose numbers are of the kind that breaks arithmetic.
inline csg::Ray hostile_ray(Rng& rng)
{
    const double values[] = {
        0.0,          -0.0,   1.0, -1.0, 1e-320, 1e308, -1e308, numbers::kInfinity, -numbers::kInfinity,
        std::nan(""), 1e-160, 0.5};
    csg::Ray ray{};
    for (int i = 0; i < 3; ++i) ray.origin[i] = values[rng.below(12)], ray.direction[i] = values[rng.below(12)];
    return ray;
}

/// A rotation, a scale and a shift, all of ordinary size.
inline csg::Transform random_transform(Rng& rng)
{
    using csg::Transform;
    return Transform::translate(rng.point(1.0)) * Transform::rotate_degrees(rng.point(180.0)) *
           Transform::scale({rng.uniform(0.5, 2.0), rng.uniform(0.5, 2.0), rng.uniform(0.5, 2.0)});
}

/// A tree's program with everything needed to ask it.
struct Object {
    csg::SolidStore store;
    csg::Program program;
    csg::Scratch scratch;
};

}  // namespace csg_test
