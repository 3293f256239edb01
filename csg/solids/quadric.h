#pragma once

#include "csg/solids/shared/common.h"

namespace csg {

/// square.(x^2, y^2, z^2) + mixed.(xy, xz, yz) + linear.(x, y, z) + constant <= 0, in its own frame: rewriting the
/// coefficients for a moved quadric loses it at a distance, moving the ray does not. It and its inverse hold the
/// surface; tangents miss (spec 5a, 2.4 and 5.8).
struct Quadric {
    glm::dvec3 square{0.0}, mixed{0.0}, linear{0.0};
    double constant = 0.0;
    Transform frame;  ///< local to world

    double value(const glm::dvec3& p) const
    {
        return p.x * (square.x * p.x + mixed.x * p.y + mixed.y * p.z + linear.x) +
               p.y * (square.y * p.y + mixed.z * p.z + linear.y) + p.z * (square.z * p.z + linear.z) + constant;
    }
    glm::dvec3 gradient(const glm::dvec3& p) const
    {
        return {2.0 * square.x * p.x + mixed.x * p.y + mixed.y * p.z + linear.x,
                2.0 * square.y * p.y + mixed.x * p.x + mixed.z * p.z + linear.y,
                2.0 * square.z * p.z + mixed.y * p.x + mixed.z * p.y + linear.z};
    }

    void intersect(const Ray& ray, SpanList& out) const
    {
        const Ray given = local_ray(frame, ray);
        const glm::dvec3& d = given.direction;
        const double length2 = glm::dot(d, d);
        if (!(length2 > 0.0)) return;
        const double shift = -glm::dot(given.origin, d) / length2;  // start near the frame's origin
        const glm::dvec3 o = given.origin + shift * d;
        const double a = d.x * (square.x * d.x + mixed.x * d.y + mixed.y * d.z) +
                         d.y * (square.y * d.y + mixed.z * d.z) + square.z * d.z * d.z;
        const double b = 0.5 * glm::dot(gradient(o), d);
        const double c = value(o);
        if (a == 0.0) {
            const double t = shift - c / (2.0 * b);
            if (b == 0.0 || !(t > -kInfinity && t < kInfinity)) {
                if (c <= 0.0) out.push(Span::everything());
                return;
            }
            out.push(b > 0.0 ? Span::until({.t = t}) : Span::from({.t = t}));
            return;
        }
        const double discriminant = b * b - a * c;
        if (!(discriminant > 0.0)) {
            if (a < 0.0) out.push(Span::everything());
            return;
        }
        const double q = -(b + std::copysign(std::sqrt(discriminant), b));  // adds numbers of one sign
        const double r0 = c / q, r1 = q / a;
        const double near = shift + glm::min(r0, r1), far = shift + glm::max(r0, r1);
        if (a > 0.0) {
            out.push({{.t = near}, {.t = far}});
        } else {
            out.push(Span::until({.t = near}));
            out.push(Span::from({.t = far}));
        }
    }
    bool contains(const glm::dvec3& p) const { return value(frame.inverse_point(p)) <= 0.0; }
    bool contains_inverted(const glm::dvec3& p) const { return value(frame.inverse_point(p)) >= 0.0; }
    glm::dvec3 normal(const glm::dvec3& p, std::uint32_t) const
    {
        return unit_or_x(frame.normal(gradient(frame.inverse_point(p))));
    }
    Aabb bounds() const;  ///< finite for ellipsoids

    static constexpr bool kClosed = true, kInverseClosed = true;
};

}  // namespace csg
