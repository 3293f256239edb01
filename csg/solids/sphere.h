#pragma once

#include "csg/solids/shared/common.h"

#include <cmath>

namespace csg {

/// The roots of |f + t d| = radius where f runs from the centre to the ray's origin. The origin is moved to the foot
/// of the perpendicular first, so nothing large cancels however far away the ray begins (after Haines, Guenther,
/// Akenine-Moeller, Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems ch. 7).
/// False for a miss, a tangent, a zero direction and for NaN.
inline bool sphere_roots(const glm::dvec3& f, const glm::dvec3& d, double radius, double& near, double& far)
{
    const double inverse_a = 1.0 / glm::dot(d, d);
    double foot_t = -glm::dot(f, d) * inverse_a;
    glm::dvec3 foot = f + foot_t * d;
    const double length2 = glm::dot(foot, foot);
    const double below = radius * radius - length2;
    if (!(below > 0.0)) return false;
    // The foot is off along the ray by the rounding of its parameter: one correction step.
    const double correction = -glm::dot(foot, d) * inverse_a;
    const double half = std::sqrt(below * inverse_a);
    near = foot_t + (correction - half);
    far = foot_t + (correction + half);
    return near <= far && far < kInfinity && near > -kInfinity;
}

/// A sphere in world space. Neither it nor its inverse holds its surface (spec 5a, 2.4).
struct Sphere {
    glm::dvec3 center{0.0};
    double radius = 1.0;  ///< positive; 0 and less is never hit

    bool interval(const Ray& ray, Interval& out) const
    {
        return radius > 0.0 && sphere_roots(ray.origin - center, ray.direction, radius, out.entry, out.exit);
    }
    bool contains(const glm::dvec3& p) const
    {
        const glm::dvec3 f = p - center;
        return radius > 0.0 && glm::dot(f, f) < radius * radius;
    }
    bool contains_inverted(const glm::dvec3& p) const
    {
        const glm::dvec3 f = p - center;
        return glm::dot(f, f) > radius * radius;
    }
    glm::dvec3 normal(const glm::dvec3& p, std::uint32_t) const { return unit_or_x(p - center); }
    Aabb bounds() const;
    glm::dvec2 uv(const glm::dvec3& p, std::uint32_t) const;  ///< spec 5a, 6; transformations not undone

    static constexpr bool kClosed = false, kInverseClosed = false;
};

/// The unit sphere under a transformation.
struct Ellipsoid {
    Transform frame;  ///< local to world

    bool interval(const Ray& ray, Interval& out) const
    {
        return sphere_roots(frame.inverse_point(ray.origin), frame.inverse_vector(ray.direction), 1.0, out.entry,
                            out.exit);
    }
    bool contains(const glm::dvec3& p) const
    {
        const glm::dvec3 f = frame.inverse_point(p);
        return glm::dot(f, f) < 1.0;
    }
    bool contains_inverted(const glm::dvec3& p) const
    {
        const glm::dvec3 f = frame.inverse_point(p);
        return glm::dot(f, f) > 1.0;
    }
    glm::dvec3 normal(const glm::dvec3& p, std::uint32_t) const
    {
        return unit_or_x(frame.normal(frame.inverse_point(p)));
    }
    Aabb bounds() const;
    glm::dvec2 uv(const glm::dvec3& p, std::uint32_t) const;  ///< spec 5a, 6

    static constexpr bool kClosed = false, kInverseClosed = false;
};

}  // namespace csg
