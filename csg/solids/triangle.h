#pragma once

#include "csg/base/points.h"
#include "csg/solids/shared/common.h"

#include <array>

namespace csg {

/// A flat or smooth triangle in world space: drawn, but bounds nothing, so no point is ever inside, inverted or not.
struct Triangle {
    glm::dvec3 corner{0.0}, edge1{1.0, 0.0, 0.0}, edge2{0.0, 1.0, 0.0};
    std::array<glm::dvec3, 3> normals{};  ///< at corner, corner + edge1, corner + edge2; used when smooth
    bool smooth = false;

    template <class P>
    struct Start {
        glm::dvec3 normal;
        P from;                       ///< from the corner
        lanes::NumberOf<P> distance;  ///< above the plane, in lengths of `normal`
    };
    template <class P>
    Start<P> start(const P& origin) const
    {
        const glm::dvec3 n = glm::cross(edge1, edge2);
        const P from = lanes::difference(origin, corner);
        return {n, from, lanes::dot(n, from)};
    }
    /// Barycentric weights of edge1 and edge2 and the parameter, by Cramer's rule after Moeller and Trumbore (1997). It
    /// bounds nothing: only the entry is drawn, and the two are the same.
    template <class D, class I>
    lanes::TruthOf<D> interval(const auto& start, const D& d, I& out) const
    {
        using V = lanes::NumberOf<D>;
        using Face = decltype(out.exit_face);
        const V zero(0.0), fx(start.from.x), fy(start.from.y), fz(start.from.z);
        const D q{fy * d.z - d.y * fz, fz * d.x - d.z * fx, fx * d.y - d.x * fy};
        const V determinant = lanes::negated(lanes::dot(d, start.normal));
        const V size = lanes::size_of(determinant), u = lanes::flipped_as(lanes::dot(edge2, q), determinant),
                v = lanes::flipped_as(lanes::negated(lanes::dot(edge1, q)), determinant);
        const lanes::Truth<V> met = (size > zero) & (u >= zero) & (v >= zero) & (u + v <= size);
        if (lanes::mask(met) == 0) return met;
        out.entry = out.exit = V(start.distance) / determinant;
        out.exit_face = Face(kUndrawnFace);
        return met;
    }
    bool crossing(const Ray& ray, double& t) const
    {
        Interval out;
        if (!interval(start(ray.origin), ray.direction, out)) return false;
        t = out.entry;
        return t > -kInfinity && t < kInfinity;
    }
    bool contains(const glm::dvec3&) const { return false; }
    bool contains_inverted(const glm::dvec3&) const { return false; }
    glm::dvec3 normal(const glm::dvec3& p, std::uint32_t) const;
    bool blends_normals() const { return smooth; }  ///< normal() may be another than the surface's
    Aabb bounds() const;

    static Triangle make(const std::array<glm::dvec3, 3>& vertices);
    static Triangle make(const std::array<glm::dvec3, 3>& vertices, const std::array<glm::dvec3, 3>& normals);

    static constexpr bool kClosed = false, kInverseClosed = false;
};

}  // namespace csg
