#pragma once

#include "csg/solids/shared/common.h"
#include "numbers/lane_arithmetic.h"

#include <cmath>

namespace csg {

/// Where a line enters and leaves a sphere; `met` where it does.
template <class V>
struct SphereRoots {
    V near, far;
    lanes::Truth<V> met;
};

/// The roots of |f + t d| = radius where f = (x, y, z) runs from the centre to the ray's origin. The origin is moved to
/// the foot of the perpendicular first, so nothing large cancels however far away the ray begins (after Haines,
/// Guenther, Akenine-Moeller, Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems ch. 7).
/// Not met: a miss, a tangent, a zero direction and NaN.
/// \param inverse 1 over the square of d
template <class V>
inline SphereRoots<V> sphere_roots(const V& x, const V& y, const V& z, const V& dx, const V& dy, const V& dz,
                                   const V& inverse, const V& radius)
{
    const V foot_t = lanes::negated(x * dx + y * dy + z * dz) * inverse;
    const V fx = x + foot_t * dx, fy = y + foot_t * dy, fz = z + foot_t * dz;
    const V below = radius * radius - (fx * fx + fy * fy + fz * fz);
    SphereRoots<V> out{V(0.0), V(0.0), below > V(0.0)};
    if (lanes::mask(out.met) == 0) return out;
    // The foot is off along the ray by the rounding of its parameter: one correction step.
    const V correction = lanes::negated(fx * dx + fy * dy + fz * dz) * inverse;
    const V half = lanes::root_of(below * inverse);
    out.near = foot_t + (correction - half);
    out.far = foot_t + (correction + half);
    out.met = out.met & (out.near <= out.far) & (out.far < V(kInfinity)) & (out.near > V(-kInfinity));
    return out;
}

inline bool sphere_interval(const glm::dvec3& f, const glm::dvec3& d, double radius, Interval& out)
{
    const auto roots = sphere_roots(f.x, f.y, f.z, d.x, d.y, d.z, 1.0 / glm::dot(d, d), radius);
    out.entry = roots.near;
    out.exit = roots.far;
    return roots.met;
}

/// A sphere in world space. Neither it nor its inverse holds its surface (spec 5a, 2.4).
struct Sphere {
    glm::dvec3 center{0.0};
    double radius = 1.0;  ///< positive; 0 and less is never hit

    bool interval(const Ray& ray, Interval& out) const
    {
        return radius > 0.0 && sphere_interval(ray.origin - center, ray.direction, radius, out);
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
        return sphere_interval(frame.inverse_point(ray.origin), frame.inverse_vector(ray.direction), 1.0, out);
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
