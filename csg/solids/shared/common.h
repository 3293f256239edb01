#pragma once

#include "csg/spans/span_list.h"

#include <cmath>

namespace csg {

/// v scaled to unit length; <1,0,0> where it has none (a cone's apex, a zero gradient): never NaN.
inline glm::dvec3 unit_or_x(const glm::dvec3& v)
{
    const double largest = glm::max(std::abs(v.x), glm::max(std::abs(v.y), std::abs(v.z)));
    if (!(largest > 0.0) || !(largest < kInfinity)) return {1.0, 0.0, 0.0};
    const glm::dvec3 scaled = v / largest;  // neither overflows nor vanishes when squared
    return scaled / std::sqrt(glm::dot(scaled, scaled));
}

/// The ray in the space of `frame`; the parameter stays that of the world ray.
inline Ray local_ray(const Transform& frame, const Ray& ray)
{
    return {frame.inverse_point(ray.origin), frame.inverse_vector(ray.direction)};
}

/// Surface coordinates of the unit vector from a sphere's centre: u about the y axis, v from pole to pole (spec 5a, 6).
glm::dvec2 sphere_uv(const glm::dvec3& n);

/// Grown by a few units in the last place, so that rounding in bounds and in crossings cannot disagree.
Aabb padded(const Aabb& box);

/// Box of `frame` applied to a local box.
Aabb transformed_box(const Transform& frame, const Aabb& local);

/// Box of centre + sum of half-axes, an ellipsoid: |row i of linear| along axis i.
Aabb ellipsoid_box(const glm::dmat3& linear, const glm::dvec3& center);

}  // namespace csg
