#pragma once

#include "csg/base/points.h"
#include "csg/solids/shared/common.h"

namespace csg {

/// The half-space dot(normal, p) <= offset: the inside of a POV-Ray `plane`. Unbounded, so its spans may begin at
/// -infinity or end at +infinity. It and its inverse both hold the surface.
struct Plane {
    glm::dvec3 normal_out{0.0, 1.0, 0.0};  ///< points out of the solid; unit length
    double offset = 0.0;                   ///< distance from the origin along the normal, scene units

    /// How deep in it rays start.
    auto start(const auto& origin) const { return offset - lanes::dot(normal_out, origin); }
    template <class D, class I>
    lanes::TruthOf<D> interval(const auto& from, const D& direction, I& out) const
    {
        using V = lanes::NumberOf<D>;
        const V depth(from), closing = lanes::dot(normal_out, direction), t = depth / closing;
        // Parallel: wholly in or wholly out. Nearly parallel needs no tolerance: it crosses, far away.
        const auto in = closing < V(0.0), along = closing == V(0.0);
        out = {lanes::choose(in, t, V(-kInfinity)), lanes::choose(in | along, V(kInfinity), t)};
        return (depth >= V(0.0)) | ((!along) & (t > V(-kInfinity)) & (t < V(kInfinity)));
    }
    bool interval(const Ray& ray, Interval& out) const { return interval(start(ray.origin), ray.direction, out); }
    /// Slack of POV-Ray's own test, an absolute distance (spec 5a, 2.4).
    static constexpr double kSkin = 1e-10;
    template <class P>
    lanes::TruthOf<P> contains(const P& p) const
    {
        return lanes::dot(normal_out, p) - offset < kSkin;
    }
    template <class P>
    lanes::TruthOf<P> contains_inverted(const P& p) const
    {
        return offset - lanes::dot(normal_out, p) < kSkin;
    }
    glm::dvec3 normal(const glm::dvec3&, std::uint32_t) const { return normal_out; }
    Aabb bounds() const;  ///< bounded on one side where the normal is an axis

    /// This half-space moved by `t`.
    Plane transformed(const Transform& t) const;

    static constexpr bool kClosed = true, kInverseClosed = true;
};

}  // namespace csg
