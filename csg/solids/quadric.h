#pragma once

#include "csg/base/points.h"
#include "csg/solids/shared/common.h"

namespace csg {

/// square.(x^2, y^2, z^2) + mixed.(xy, xz, yz) + linear.(x, y, z) + constant <= 0, in its own frame: rewriting the
/// coefficients for a moved quadric loses it at a distance, moving the ray does not. It and its inverse hold the
/// surface; tangents miss (spec 5a, 2.4 and 5.8).
struct Quadric {
    glm::dvec3 square{0.0}, mixed{0.0}, linear{0.0};
    double constant = 0.0;
    Transform frame;  ///< local to world

    auto value(const auto& p) const
    {
        return p.x * (square.x * p.x + mixed.x * p.y + mixed.y * p.z + linear.x) +
               p.y * (square.y * p.y + mixed.z * p.z + linear.y) + p.z * (square.z * p.z + linear.z) + constant;
    }
    template <class P>
    P gradient(const P& p) const
    {
        return {2.0 * square.x * p.x + mixed.x * p.y + mixed.y * p.z + linear.x,
                2.0 * square.y * p.y + mixed.x * p.x + mixed.z * p.z + linear.y,
                2.0 * square.z * p.z + mixed.y * p.x + mixed.z * p.y + linear.z};
    }

    /// a t^2 + 2 b t + c along rays, counted from `shift`, and where it is 0 if a is not.
    template <class V>
    struct Course {
        V shift, a, b, c, discriminant, near, far;
    };
    auto start(const auto& origin) const { return lanes::into(frame, origin); }
    template <class D>
    auto course(const auto& from, const D& direction) const
    {
        using V = lanes::NumberOf<D>;
        const D d = lanes::turned(frame, direction);
        Course<V> out;
        out.shift = lanes::negated(lanes::dot(from, d)) / lanes::dot(d, d);  // start near the frame's origin
        const D o = lanes::advanced(from, out.shift, d);
        out.a = d.x * (square.x * d.x + mixed.x * d.y + mixed.y * d.z) + d.y * (square.y * d.y + mixed.z * d.z) +
                square.z * d.z * d.z;
        out.b = 0.5 * lanes::dot(gradient(o), d);
        out.c = value(o);
        out.discriminant = out.b * out.b - out.a * out.c;
        const V q = lanes::negated(out.b + lanes::signed_as(lanes::root_of(out.discriminant), out.b));  // of one sign
        const V r0 = out.c / q, r1 = q / out.a;
        out.near = out.shift + lanes::smaller(r0, r1);
        out.far = out.shift + lanes::larger(r0, r1);
        return out;
    }

    void intersect(const Ray& ray, SpanList& out) const
    {
        const Course<double> at = course(start(ray.origin), ray.direction);
        if (at.a == 0.0) {
            const double t = at.shift - at.c / (2.0 * at.b);
            if (at.b == 0.0 || !(t > -kInfinity && t < kInfinity)) {
                if (at.c <= 0.0) out.push(Span::everything());
                return;
            }
            out.push(at.b > 0.0 ? Span::until({.t = t}) : Span::from({.t = t}));
            return;
        }
        if (!(at.discriminant > 0.0)) {
            if (at.a < 0.0) out.push(Span::everything());
        } else if (at.a > 0.0) {
            out.push({{.t = at.near}, {.t = at.far}});
        } else {
            out.push(Span::until({.t = at.near}));
            out.push(Span::from({.t = at.far}));
        }
    }
    template <class P>
    lanes::TruthOf<P> contains(const P& p) const
    {
        return value(lanes::into(frame, p)) <= 0.0;
    }
    template <class P>
    lanes::TruthOf<P> contains_inverted(const P& p) const
    {
        return value(lanes::into(frame, p)) >= 0.0;
    }
    glm::dvec3 normal(const glm::dvec3& p, std::uint32_t) const
    {
        return unit_or_x(frame.normal(gradient(frame.inverse_point(p))));
    }
    Aabb bounds() const;  ///< finite for ellipsoids

    static constexpr bool kClosed = true, kInverseClosed = true;
};

}  // namespace csg
