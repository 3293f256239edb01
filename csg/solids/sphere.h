#pragma once

#include "csg/base/points.h"
#include "csg/solids/shared/common.h"

namespace csg {

/// The roots of |f + t d| = radius where f runs from the centre to the ray's origin. The origin is moved to the foot of
/// the perpendicular first, so nothing large cancels however far away the ray begins (after Haines, Guenther,
/// Akenine-Moeller, Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems ch. 7).
/// False: a miss, a tangent, a zero direction and NaN.
/// \param inverse 1 over the square of d
template <class P, class D, class V, class I>
inline lanes::Truth<V> sphere_interval(const P& f, const D& d, const V& inverse, const V& radius, I& out)
{
    const V foot_t = lanes::negated(lanes::dot(f, d)) * inverse;
    const D foot = lanes::advanced(f, foot_t, d);
    const V below = radius * radius - lanes::dot(foot, foot);
    lanes::Truth<V> met = below > V(0.0);
    if (lanes::mask(met) == 0) return met;
    // The foot is off along the ray by the rounding of its parameter: one correction step.
    const V correction = lanes::negated(lanes::dot(foot, d)) * inverse;
    const V half = lanes::root_of(below * inverse);
    out.entry = foot_t + (correction - half);
    out.exit = foot_t + (correction + half);
    return met & (out.entry <= out.exit) & (out.exit < V(kInfinity)) & (out.entry > V(-kInfinity));
}
template <class P, class D, class I>
inline lanes::TruthOf<D> sphere_interval(const P& f, const D& d, double radius, I& out)
{
    using V = lanes::NumberOf<D>;
    return sphere_interval(f, d, V(1.0) / lanes::dot(d, d), V(radius), out);
}

/// A sphere in world space. Neither it nor its inverse holds its surface (spec 5a, 2.4).
struct Sphere {
    glm::dvec3 center{0.0};
    double radius = 1.0;  ///< positive; 0 and less is never hit

    auto start(const auto& origin) const { return lanes::difference(origin, center); }
    template <class D, class I>
    lanes::TruthOf<D> interval(const auto& from, const D& direction, I& out) const
    {
        return radius > 0.0 ? sphere_interval(from, direction, radius, out) : lanes::TruthOf<D>(false);
    }
    bool interval(const Ray& ray, Interval& out) const { return interval(start(ray.origin), ray.direction, out); }
    template <class P>
    lanes::TruthOf<P> contains(const P& p) const
    {
        const P f = lanes::difference(p, center);
        return lanes::dot(f, f) < (radius > 0.0 ? radius * radius : 0.0);
    }
    template <class P>
    lanes::TruthOf<P> contains_inverted(const P& p) const
    {
        const P f = lanes::difference(p, center);
        return lanes::dot(f, f) > radius * radius;
    }
    glm::dvec3 normal(const glm::dvec3& p, std::uint32_t) const { return unit_or_x(p - center); }
    Aabb bounds() const;
    glm::dvec2 uv(const glm::dvec3& p, std::uint32_t) const;  ///< spec 5a, 6; transformations not undone

    static constexpr bool kClosed = false, kInverseClosed = false;
};

/// The unit sphere under a transformation.
struct Ellipsoid {
    Transform frame;  ///< local to world

    auto start(const auto& origin) const { return lanes::into(frame, origin); }
    template <class D, class I>
    lanes::TruthOf<D> interval(const auto& from, const D& direction, I& out) const
    {
        return sphere_interval(from, lanes::turned(frame, direction), 1.0, out);
    }
    bool interval(const Ray& ray, Interval& out) const { return interval(start(ray.origin), ray.direction, out); }
    template <class P>
    lanes::TruthOf<P> contains(const P& p) const
    {
        const P f = lanes::into(frame, p);
        return lanes::dot(f, f) < 1.0;
    }
    template <class P>
    lanes::TruthOf<P> contains_inverted(const P& p) const
    {
        const P f = lanes::into(frame, p);
        return lanes::dot(f, f) > 1.0;
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
