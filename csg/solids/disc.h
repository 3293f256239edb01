#pragma once

#include "csg/base/points.h"
#include "csg/solids/shared/common.h"

namespace csg {

/// A flat ring: z = 0 and hole^2 <= x^2 + y^2 <= radius^2 in its own frame. What it bounds is the whole half-space z <
/// 0 (spec 5a, 5.6): a crossing beyond the rim is there, but not drawn.
struct Disc {
    double radius = 1.0, hole = 0.0;
    Transform frame;  ///< local to world; local z is the disc's normal

    bool interval(const Ray& ray, Interval& out) const
    {
        const Ray local = local_ray(frame, ray);
        out = Interval{};
        if (local.direction.z == 0.0) return local.origin.z < 0.0;
        const double t = -local.origin.z / local.direction.z;
        if (!(t > -kInfinity && t < kInfinity)) return local.origin.z < 0.0;
        const glm::dvec2 p = glm::dvec2(local.origin) + t * glm::dvec2(local.direction);
        const double r2 = glm::dot(p, p);
        const bool drawn = r2 <= radius * radius && r2 >= hole * hole;
        const std::uint32_t face = drawn ? 0u : kUndrawnFace;
        if (local.direction.z < 0.0) out.entry = t, out.entry_face = face;
        else out.exit = t, out.exit_face = face;
        return true;
    }
    template <class P>
    lanes::TruthOf<P> contains(const P& p) const
    {
        return lanes::into(frame, p).z < 0.0;
    }
    template <class P>
    lanes::TruthOf<P> contains_inverted(const P& p) const
    {
        return lanes::into(frame, p).z >= 0.0;
    }
    glm::dvec3 normal(const glm::dvec3&, std::uint32_t) const { return unit_or_x(frame.normal({0.0, 0.0, 1.0})); }
    Aabb bounds() const { return Aabb::everything(); }  ///< of the half-space
    Aabb drawn_bounds() const;                          ///< of the ring

    /// Frame with local z along `normal` (any length but 0).
    static Disc make(const glm::dvec3& center, const glm::dvec3& normal, double radius, double hole,
                     const Transform& t);

    static constexpr bool kClosed = false, kInverseClosed = true;
};

}  // namespace csg
