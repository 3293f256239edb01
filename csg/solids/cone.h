#pragma once

#include "csg/solids/shared/slab.h"
#include "csg/solids/shared/tube.h"

namespace csg {

/// x^2 + y^2 = z^2 between z = low and z = 1, in its own frame: apex at 0, the large end at 1. low < 0 is POV-Ray's
/// double cone of a negative radius, which is not convex (spec 5a, 5.4). Surface held as by a cylinder.
struct Cone {
    double low = 0.0;  ///< in (-1, 1)
    Transform frame;   ///< local to world
    bool open = false;

    bool convex() const { return low >= 0.0; }

    auto start(const auto& origin) const { return lanes::into(frame, origin); }
    /// Only for convex(): the longer of the pieces.
    template <class D, class I>
    lanes::TruthOf<D> interval(const auto& from, const D& direction, I& out) const
    {
        I part[2];
        lanes::TruthOf<D> met[2];
        pieces(from, direction, part, met);
        out = part[0];
        if (lanes::mask(met[1]) == 0) return met[0];
        const auto second = met[1] & ((!met[0]) | (part[1].exit - part[1].entry > part[0].exit - part[0].entry));
        out = {lanes::choose(second, part[1].entry, part[0].entry), lanes::choose(second, part[1].exit, part[0].exit),
               lanes::choose(second, part[1].entry_face, part[0].entry_face),
               lanes::choose(second, part[1].exit_face, part[0].exit_face)};
        return met[0] | met[1];
    }
    bool interval(const Ray& ray, Interval& out) const { return interval(start(ray.origin), ray.direction, out); }
    void intersect(const Ray& ray, SpanList& out) const
    {
        Interval part[2];
        bool met[2] = {false, false};
        if (convex()) met[0] = interval(ray, part[0]);
        else pieces(start(ray.origin), ray.direction, part, met);
        for (int i = 0; i < 2; ++i)
            if (met[i])
                out.push(
                    {{.t = part[i].entry, .face = part[i].entry_face}, {.t = part[i].exit, .face = part[i].exit_face}});
    }
    template <class P>
    lanes::TruthOf<P> contains(const P& p) const
    {
        const P l = lanes::into(frame, p);
        return within_tube(l, lanes::NumberOf<P>(lanes::size_of(l.z) + skin(open)), low, skin(open));
    }
    template <class P>
    lanes::TruthOf<P> contains_inverted(const P& p) const
    {
        return !contains(p);
    }
    glm::dvec3 normal(const glm::dvec3& p, std::uint32_t face) const { return tube_normal(frame, p, face, -1.0); }
    Aabb bounds() const;

    /// Up to two intervals, in order: what the quadric's inside and the slab low <= z <= 1 have in common.
    template <class D, class I>
    void pieces(const auto& from, const D& direction, I (&out)[2], lanes::TruthOf<D> (&met)[2]) const
    {
        using V = lanes::NumberOf<D>;
        using Truth = lanes::Truth<V>;
        const V zero(0.0), before(-kInfinity), beyond(kInfinity);
        const D d = lanes::turned(frame, direction);
        const V length2 = lanes::dot(d, d);
        // From the point nearest to the apex; the discriminant and both outer coefficients as products (Lagrange's
        // identity), so a thin cone or a ray past the apex loses nothing.
        const V shift = lanes::negated(lanes::dot(from, d)) / length2;
        const D o = lanes::advanced(from, shift, d);
        I ends;
        Truth between = slab(o.z, d.z, low, 1.0, ends) & (length2 > zero);
        met[0] = met[1] = Truth(false);
        if (lanes::mask(between) == 0) return;
        name_ends(open, ends);

        const V across = lanes::root_of(d.x * d.x + d.y * d.y), radius = lanes::root_of(o.x * o.x + o.y * o.y);
        const V dz = lanes::size_of(d.z), oz = lanes::size_of(o.z);
        const V a = (across - dz) * (across + dz), b = o.x * d.x + o.y * d.y - o.z * d.z;
        const V c = (radius - oz) * (radius + oz);
        const V wx = o.z * d.x - d.z * o.x, wy = o.z * d.y - d.z * o.y;
        const V w = lanes::root_of(wx * wx + wy * wy), m = lanes::size_of(o.x * d.y - o.y * d.x);
        const V discriminant = (w - m) * (w + m);
        between = between & (discriminant >= zero);
        if (lanes::mask(between) == 0) return;

        // Where a t^2 + 2 b t + c <= 0.
        const V q = lanes::negated(b + lanes::signed_as(lanes::root_of(discriminant), b));
        const V r0 = lanes::choose(q != zero, c / q, zero), r1 = q / a;
        const V near = lanes::choose(r0 < r1, r0, r1), far = lanes::choose(r0 < r1, r1, r0);
        const Truth linear = a == zero, two = a < zero;
        I side[2] = {{lanes::choose(two, before, near), lanes::choose(two, near, far)}, {far, beyond}};
        met[0] = between;
        met[1] = between & two;
        if (lanes::mask(linear) != 0) {
            const Truth still = q == zero, rising = b > zero;
            side[0].entry = lanes::choose(linear, lanes::choose(still | rising, before, r0), side[0].entry);
            side[0].exit = lanes::choose(linear, lanes::choose((!still) & rising, r0, beyond), side[0].exit);
            met[0] = between & ((!linear) | (!still) | (c <= zero));
        }
        for (int k = 0; k < 2; ++k) {
            out[k] = ends;
            if (lanes::mask(met[k]) == 0) continue;
            met[k] = met[k] & narrow(out[k], side[k]);
            out[k].entry = out[k].entry + shift;
            out[k].exit = out[k].exit + shift;
            met[k] = met[k] & (out[k].entry <= out[k].exit);
        }
    }

    /// From two different radii; the points must differ. Returns false where POV-Ray makes it a cylinder, with the
    /// radius to use in `cylinder_radius`.
    static bool make(const glm::dvec3& first, double first_radius, const glm::dvec3& second, double second_radius,
                     bool open, const Transform& t, Cone& out, double& cylinder_radius);
};

}  // namespace csg
