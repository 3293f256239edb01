#pragma once

#include "csg/base/points.h"
#include "csg/solids/shared/common.h"
#include "csg/solids/shared/slab.h"
#include "csg/solids/shared/tube.h"

namespace csg {

/// Radius 1 about z from z = 0 to z = 1, in its own frame. Without ends when open, but it bounds the same set. Closed
/// ones leave their surface out, open ones hold it (spec 5a, 2.4).
struct Cylinder {
    Transform frame;  ///< local to world
    bool open = false;

    auto start(const auto& origin) const { return lanes::into(frame, origin); }
    template <class D, class I>
    lanes::TruthOf<D> interval(const auto& from, const D& direction, I& out) const
    {
        using V = lanes::NumberOf<D>;
        const D d = lanes::turned(frame, direction);
        const lanes::Truth<V> between = slab(V(from.z), d.z, 0.0, 1.0, out);
        if (lanes::mask(between) == 0) return between;
        name_ends(open, out);
        const V x(from.x), y(from.y), a = d.x * d.x + d.y * d.y;
        const lanes::Truth<V> along = !(a > V(kAlong));
        // About the point nearest to the axis the roots are symmetric and nothing large cancels.
        const V inverse_a = V(1.0) / a;
        const V foot_t = lanes::negated(x * d.x + y * d.y) * inverse_a;
        const V fx = x + foot_t * d.x, fy = y + foot_t * d.y;
        const V below = V(1.0) - (fx * fx + fy * fy);
        const V correction = lanes::negated(fx * d.x + fy * d.y) * inverse_a;
        const V half = lanes::root_of(below * inverse_a);
        const V entry = foot_t + (correction - half), exit = foot_t + (correction + half);
        const lanes::Truth<V> met = lanes::choose(along, (x * x + y * y <= V(1.0)) & (out.entry > V(-kInfinity)),
                                                  (below >= V(0.0)) & (entry <= exit));
        return between & met &
               narrow(out, {lanes::choose(along, V(-kInfinity), entry), lanes::choose(along, V(kInfinity), exit)});
    }
    bool interval(const Ray& ray, Interval& out) const { return interval(start(ray.origin), ray.direction, out); }
    template <class P>
    lanes::TruthOf<P> contains(const P& p) const
    {
        return within_tube(lanes::into(frame, p), lanes::NumberOf<P>(1.0 + skin(open)), 0.0, skin(open));
    }
    template <class P>
    lanes::TruthOf<P> contains_inverted(const P& p) const
    {
        return !contains(p);
    }
    glm::dvec3 normal(const glm::dvec3& p, std::uint32_t face) const { return tube_normal(frame, p, face, 0.0); }
    Aabb bounds() const;

    /// POV-Ray's frame: base at the second point, z toward the first. The points must differ.
    static Cylinder make(const glm::dvec3& first, const glm::dvec3& second, double radius, bool open,
                         const Transform& t = {}, Roundings by = Roundings::Own);

    /// Square of a direction across the axis that is none: the side lies beyond any distance.
    static constexpr double kAlong = 1e-300;
};

}  // namespace csg
