#pragma once

#include "csg/freeform/shared/intersection_list.h"
#include "csg/solids/shared/outline_shape.h"

#include <memory>
#include <span>

namespace csg {

/// A plane region whose cross-section at height y is y times as large, mirrored below the apex at the origin, between
/// two heights (spec 5b, 6.5; manual: Prism, conic sweep). Points of the outline are (x, z). It holds its surface, its
/// inverse does not. Faces: 0 its low end, 1 its high end, 2 + piece of the outline.
class ConicPrism {
public:
    /// `reach`: what POV-Ray takes for the outline's box.
    ConicPrism(std::shared_ptr<const OutlineShape> outline, double low, double high, bool open,
               const glm::dvec2 (&reach)[2]);

    void intersect(const Ray& ray, IntersectionList& out) const;
    static bool intersects_many() { return true; }
    void intersect_many(std::span<const Ray> rays, IntersectionList* out) const;
    bool contains(const glm::dvec3& p) const;
    glm::dvec3 gradient(const glm::dvec3& p, std::uint32_t face) const;
    Aabb bounds() const { return outline_->empty() ? Aabb{} : box(outline_->lower(), outline_->upper()); }
    Aabb extent() const { return extent_; }

    static constexpr bool kSurface = false;
    static constexpr bool kClosed = true, kInverseClosed = false;

private:
    static constexpr std::uint32_t kLow = 0, kHigh = 1, kFirstWall = 2;
    static constexpr double kWider = 1e-9;  // of an end of a range: more than ends that count as one differ

    class Lanes;
    template <class T>
    struct Course;

    Aabb box(const glm::dvec2& lower, const glm::dvec2& upper) const;
    std::uint32_t end_face(std::uint32_t face) const { return open_ ? kUndrawnFace : face; }
    /// The pieces of the ray between walls, told in order. `inside`: before all of them.
    template <class Walls>
    void tell(double shift, const Interval& within, const Walls& walls, bool inside, IntersectionList& out) const;

    std::shared_ptr<const OutlineShape> outline_;
    double low_, high_;
    bool open_;
    Aabb extent_;
};

}  // namespace csg
