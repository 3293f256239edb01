#pragma once

#include "csg/solids/torus/torus.h"
#include "tests/csg/support.h"

#include <cmath>

namespace csg_test {

/// A ray through the tube, or one that touches it to within 2^-10 to 2^-45 of the tube's radius.
inline csg::Ray tube_ray(Rng& rng, const csg::Torus& torus, bool tangent)
{
    const double around = rng.uniform(0.0, 6.283185307179586), about = rng.uniform(0.0, 6.283185307179586);
    const glm::dvec3 out(std::cos(about) * std::cos(around), std::sin(about), std::cos(about) * std::sin(around));
    const double touch = 1.0 + (rng.coin() ? 1.0 : -1.0) * std::ldexp(1.0, -10 - rng.below(36));
    const double depth = torus.minor * (tangent ? touch : rng.uniform(0.0, 1.0));
    const glm::dvec3 target = torus.major * glm::dvec3(std::cos(around), 0.0, std::sin(around)) + depth * out;
    glm::dvec3 direction = rng.direction();
    if (tangent) direction = glm::normalize(glm::cross(out, direction));
    return {target - rng.uniform(1.0, 8.0) * direction, direction};
}

}  // namespace csg_test
