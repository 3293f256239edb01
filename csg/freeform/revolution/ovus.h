#pragma once

#include "csg/freeform/shared/intersection_list.h"

namespace csg {

/// An egg: a sphere at the origin, another on its top, and what an arc turned about the y axis adds between them (spec
/// 5a, 5.12; manual: Ovus). It is convex and does not hold its surface, its inverse does. Faces: 0 the sphere below, 1
/// the sphere above, 2 between. One with a step holds both spheres whole, though parts of them are not drawn (spec 7c,
/// 2).
class Ovus {
public:
    /// Radii; 0 <= top < 2 bottom. The second sphere's middle is on the first one, and the arc's radius twice the
    /// larger.
    Ovus(double bottom, double top);
    /// With the distance of the spheres' middles, at least `bottom` and more than `top - bottom`, and the arc's radius,
    /// more than half the sum of the three (POV-Ray 3.8). With the larger sphere on top it may have a step.
    Ovus(double bottom, double top, double distance, double arc);

    void intersect(const Ray& ray, IntersectionList& out) const;
    bool contains(const glm::dvec3& p) const;
    bool contains_inverted(const glm::dvec3& p) const { return !contains(p); }
    glm::dvec3 gradient(const glm::dvec3& p, std::uint32_t face) const;
    glm::dvec2 uv(const glm::dvec3& p, std::uint32_t face) const;
    Aabb bounds() const;

    bool reports_touches() const { return stepped_; }

    static constexpr bool kSurface = false;
    static constexpr bool kClosed = false, kInverseClosed = true;

private:
    static constexpr std::uint32_t kBelow = 0, kAbove = 1, kBetween = 2;

    void intersect_stepped(const glm::dvec3& o, const glm::dvec3& e, double shift, double length,
                           IntersectionList& out) const;
    double tip() const;
    bool between(const glm::dvec3& o, const glm::dvec3& e, double& from, double& to, bool both) const;

    double bottom_, top_, distance_;
    double arc_;  ///< radius of the arc: (rho + offset)^2 + (y - height)^2 = arc^2
    double offset_, height_;
    double low_, high_;  ///< heights between which it is used
    bool heights_of_38_ = false, stepped_ = false;
};

}  // namespace csg
