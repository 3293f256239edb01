#pragma once

#include "csg/base/points.h"
#include "csg/freeform/shared/ray_batch.h"
#include "csg/solids/shared/slab.h"

namespace csg {

/// An arc turned about the line between its ends' middles, between two discs: a part of a spindle torus's inner sheet
/// (POV-Ray 3.8's lemon; spec 7c, 1). It is convex. The discs belong to it, the surface of the arc does not; without
/// the discs it bounds the same set. Faces are those of a cylinder.
class Lemon {
public:
    /// The middles must differ, radii must not be negative; `arc` is the arc's radius, at least least_arc().
    Lemon(const glm::dvec3& base, double base_radius, const glm::dvec3& cap, double cap_radius, double arc, bool open);
    /// That of an arc about a point of the axis: the lemon is a part of a ball.
    static double least_arc(double base_radius, double cap_radius, double height);

    void intersect(const Ray& ray, IntersectionList& out) const;
    bool intersects_many() const { return true; }
    void intersect_many(std::span<const Ray> rays, IntersectionList* out) const;
    bool contains(const glm::dvec3& p) const;
    bool contains_inverted(const glm::dvec3& p) const { return !contains(p); }
    glm::dvec3 gradient(const glm::dvec3& p, std::uint32_t face) const;
    Aabb bounds() const;
    Aabb extent(const Transform& moved) const;

    static constexpr bool kSurface = false;
    static constexpr bool kClosed = true, kInverseClosed = false;

private:
    template <class P>
    lanes::TruthOf<P> inside_of(const P& origin, const P& way, EndsOf<lanes::NumberOf<P>>& out) const;
    template <class P, class V>
    void beyond(const P& o, const P& d, const V& t, V& value, V& slope) const;
    Aabb space() const;

    Transform frame_;  ///< from its own space: the axis is z, the middle between the ends is the origin
    double height_, radius_, widest_;
    double offset_, middle_;  ///< the arc: (rho + offset)^2 + (z - middle)^2 = arc^2, z from the base
    bool open_;
};

}  // namespace csg
