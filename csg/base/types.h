#pragma once

#include "csg/base/numbers.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>

namespace csg {

/// What render/ looks up for the face that was crossed; csg/ never asks what it means.
using SurfaceId = std::uint32_t;
inline constexpr SurfaceId kNoSurface = 0xffffffffu;

/// A ray in world or local space. `direction` has unit length where the ray starts (camera, mirror, light);
/// in a solid's own space it keeps the parameter of the world ray, so it may have any length.
struct Ray {
    glm::dvec3 origin;
    glm::dvec3 direction;
    glm::dvec3 at(double t) const { return origin + t * direction; }
};

/// An axis-aligned box; infinite where the content is unbounded, `lower > upper` where it is empty.
struct Aabb {
    glm::dvec3 lower{kInfinity};
    glm::dvec3 upper{-kInfinity};

    static Aabb everything() { return {glm::dvec3(-kInfinity), glm::dvec3(kInfinity)}; }
    bool empty() const { return !(lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z); }
    bool finite() const;
    void include(const glm::dvec3& p)
    {
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    }
    void include(const Aabb& box)
    {
        lower = glm::min(lower, box.lower);
        upper = glm::max(upper, box.upper);
    }
    bool holds(const Aabb& box) const
    {
        return glm::all(glm::lessThanEqual(lower, box.lower)) && glm::all(glm::greaterThanEqual(upper, box.upper));
    }
    Aabb intersected(const Aabb& box) const { return {glm::max(lower, box.lower), glm::min(upper, box.upper)}; }
};

/// An affine map and its inverse, kept together as POV-Ray does: the inverse is accumulated, never recomputed.
/// Column-vector convention (p' = linear * p + offset).
struct Transform {
    glm::dmat3 linear{1.0};
    glm::dvec3 offset{0.0};
    glm::dmat3 inverse_linear{1.0};
    glm::dvec3 inverse_offset{0.0};

    glm::dvec3 point(const glm::dvec3& p) const { return linear * p + offset; }
    glm::dvec3 vector(const glm::dvec3& v) const { return linear * v; }
    /// Near an object far from the origin the difference is exact; inverse_offset, rounded, would cost its digits
    /// (bench/numerics: 1e9 away 4e-7 of the object's size).
    glm::dvec3 inverse_point(const glm::dvec3& p) const { return inverse_linear * (p - offset); }
    glm::dvec3 inverse_vector(const glm::dvec3& v) const { return inverse_linear * v; }
    /// A normal of the local space in world space; not normalised.
    glm::dvec3 normal(const glm::dvec3& n) const { return glm::transpose(inverse_linear) * n; }
    bool identity() const;
    Transform inverted() const { return {inverse_linear, inverse_offset, linear, offset}; }

    static Transform translate(const glm::dvec3& by);
    static Transform scale(const glm::dvec3& by);               ///< components must not be 0
    static Transform rotate_degrees(const glm::dvec3& angles);  ///< about x, then y, then z (manual 2.3.1.4)
};

/// `outer` after `inner`.
Transform operator*(const Transform& outer, const Transform& inner);

}  // namespace csg
