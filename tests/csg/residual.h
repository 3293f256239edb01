#pragma once

#include "csg/solids/solid.h"

#include <cmath>

/// How far a crossing is from its surface, evaluated in 113-bit arithmetic from the exact input doubles.
namespace csg_test {

using Quad = __float128;
struct Quad3 {
    Quad x, y, z;
};

inline Quad root(Quad v)
{
    if (v <= 0) return 0;
    Quad r = std::sqrt(static_cast<long double>(v));
    for (int i = 0; i < 2; ++i) r = (r + v / r) / 2;
    return r;
}

inline Quad3 at(const csg::Ray& ray, double t)
{
    const Quad q = t;
    return {ray.origin.x + q * ray.direction.x, ray.origin.y + q * ray.direction.y, ray.origin.z + q * ray.direction.z};
}

inline Quad3 local(const csg::Transform& f, const Quad3& p)
{
    const glm::dmat3& m = f.inverse_linear;
    const glm::dvec3& o = f.inverse_offset;
    return {m[0].x * p.x + m[1].x * p.y + m[2].x * p.z + o.x, m[0].y * p.x + m[1].y * p.y + m[2].y * p.z + o.y,
            m[0].z * p.x + m[1].z * p.y + m[2].z * p.z + o.z};
}

inline Quad length(const Quad3& p) { return root(p.x * p.x + p.y * p.y + p.z * p.z); }

// Distance from the surface in the solid's own units; the face named must be the face met.
inline Quad off(const csg::Sphere& s, const Quad3& p, std::uint32_t)
{
    return length({p.x - s.center.x, p.y - s.center.y, p.z - s.center.z}) - s.radius;
}
inline Quad off(const csg::Ellipsoid& s, const Quad3& p, std::uint32_t) { return length(local(s.frame, p)) - 1; }
inline Quad off_box(const glm::dvec3& lower, const glm::dvec3& upper, const Quad3& p, std::uint32_t face)
{
    const int axis = static_cast<int>(face / 2);
    const Quad v = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
    return v - (face % 2 == 0 ? lower[axis] : upper[axis]);
}
inline Quad off(const csg::Box& s, const Quad3& p, std::uint32_t face) { return off_box(s.lower, s.upper, p, face); }
inline Quad off(const csg::OrientedBox& s, const Quad3& p, std::uint32_t face)
{
    return off_box(s.lower, s.upper, local(s.frame, p), face);
}
inline Quad off(const csg::Extrusion& s, const Quad3& p, std::uint32_t face)
{
    const Quad3 l = local(s.frame, p);
    if (face < csg::Extrusion::kFirstWall) return l.z - (face == csg::Extrusion::kLow ? s.low : s.high);
    const csg::OutlinePiece& c = s.shape->pieces()[face - csg::Extrusion::kFirstWall];
    const glm::dvec2 near{static_cast<double>(l.x), static_cast<double>(l.y)};
    const Quad w = s.shape->parameter(face - csg::Extrusion::kFirstWall, near);
    // Across the curve: along it the nearest point is not known exactly, and need not be.
    const Quad x = ((c.a.x * w + c.b.x) * w + c.c.x) * w + c.d.x - l.x,
               y = ((c.a.y * w + c.b.y) * w + c.c.y) * w + c.d.y - l.y;
    const Quad sx = (3 * c.a.x * w + 2 * c.b.x) * w + c.c.x, sy = (3 * c.a.y * w + 2 * c.b.y) * w + c.c.y;
    return (x * sy - y * sx) / root(sx * sx + sy * sy);
}
/// First order: the value over the slope.
inline Quad off(const csg::Polynomial& s, const Quad3& p, std::uint32_t)
{
    const Quad3 l = local(s.frame, p);
    const int n = s.shape->degree();
    Quad value = 0;
    std::size_t next = 0;
    for (int i = n; i >= 0; --i)
        for (int j = n - i; j >= 0; --j)
            for (int k = n - i - j; k >= 0; --k) {
                Quad term = s.shape->coefficients()[next++];
                for (int m = 0; m < i; ++m) term *= l.x;
                for (int m = 0; m < j; ++m) term *= l.y;
                for (int m = 0; m < k; ++m) term *= l.z;
                value += term;
            }
    const glm::dvec3 slope =
        s.shape->gradient({static_cast<double>(l.x), static_cast<double>(l.y), static_cast<double>(l.z)});
    return value / glm::length(slope);
}
inline Quad off(const csg::Plane& s, const Quad3& p, std::uint32_t)
{
    return s.normal_out.x * p.x + s.normal_out.y * p.y + s.normal_out.z * p.z - s.offset;
}
inline Quad off(const csg::Cylinder& s, const Quad3& p, std::uint32_t face)
{
    const Quad3 l = local(s.frame, p);
    if (face == csg::kSide) return root(l.x * l.x + l.y * l.y) - 1;
    return s.open && face == csg::kUndrawnFace ? Quad(0) : face == csg::kLowEnd ? l.z : l.z - 1;
}
inline Quad off(const csg::Cone& s, const Quad3& p, std::uint32_t face)
{
    const Quad3 l = local(s.frame, p);
    if (face == csg::kSide) return root(l.x * l.x + l.y * l.y) - (l.z < 0 ? -l.z : l.z);
    return s.open && face == csg::kUndrawnFace ? Quad(0) : face == csg::kLowEnd ? l.z - s.low : l.z - 1;
}
inline Quad off(const csg::Torus& s, const Quad3& p, std::uint32_t)
{
    const Quad3 l = local(s.frame, p);
    const Quad rho = root(l.x * l.x + l.z * l.z);
    const auto sheet = [&](Quad across) { return root(across * across + l.y * l.y) - s.minor; };
    const Quad outer = sheet(rho - s.major), inner = sheet(rho + s.major);
    return (inner < 0 ? -inner : inner) < (outer < 0 ? -outer : outer) ? inner : outer;
}
inline Quad off(const csg::Quadric& s, const Quad3& p, std::uint32_t)
{
    const Quad3 l = local(s.frame, p);
    const Quad f = l.x * (s.square.x * l.x + s.mixed.x * l.y + s.mixed.y * l.z + s.linear.x) +
                   l.y * (s.square.y * l.y + s.mixed.z * l.z + s.linear.y) + l.z * (s.square.z * l.z + s.linear.z) +
                   s.constant;
    const glm::dvec3 g =
        s.gradient(glm::dvec3(static_cast<double>(l.x), static_cast<double>(l.y), static_cast<double>(l.z)));
    return f / glm::max(glm::length(g), 1e-3);
}
inline Quad off(const csg::Disc& s, const Quad3& p, std::uint32_t) { return local(s.frame, p).z; }

template <class T>
double residual(const T& solid, const csg::Ray& ray, double t, std::uint32_t face)
{
    const Quad d = off(solid, at(ray, t), face);
    return static_cast<double>(d < 0 ? -d : d);
}

}  // namespace csg_test
