#pragma once

#include "csg/base/types.h"

#include <cmath>

namespace csg {

/// The point of a ray at t with one rounding a coordinate: exact where a ray from far away comes near the origin,
/// though t has few digits left.
inline glm::dvec3 fused_at(const Ray& ray, double t)
{
    return {std::fma(t, ray.direction.x, ray.origin.x), std::fma(t, ray.direction.y, ray.origin.y),
            std::fma(t, ray.direction.z, ray.origin.z)};
}

}  // namespace csg
