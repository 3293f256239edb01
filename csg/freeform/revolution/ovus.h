#pragma once

#include "csg/base/points.h"
#include "csg/freeform/shared/ray_batch.h"
#include "csg/solids/shared/slab.h"

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
    bool intersects_many() const { return !stepped_; }
    void intersect_many(std::span<const Ray> rays, IntersectionList* out) const;
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

    template <class P>
    struct Course;
    template <class P>
    Course<P> course(const P& origin, const P& way) const;
    template <class P>
    lanes::TruthOf<P> inside_of(const P& origin, const P& way, lanes::NumberOf<P> start, bool first_only,
                                EndsOf<lanes::NumberOf<P>>& out) const;
    void intersect_stepped(const Ray& ray, IntersectionList& out) const;
    double tip() const;
    template <class P, class V>
    void beyond(const P& o, const P& e, const V& s, V& value, V& slope) const;

    double bottom_, top_, distance_;
    double arc_;  ///< radius of the arc: (rho + offset)^2 + (y - height)^2 = arc^2
    double offset_, height_;
    double low_, high_;  ///< heights between which it is used
    bool heights_of_38_ = false, stepped_ = false;
};

}  // namespace csg
