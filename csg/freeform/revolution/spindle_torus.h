#pragma once

#include "csg/freeform/shared/intersection_list.h"
#include "csg/solids/torus/torus.h"

namespace csg {

/// A torus about y whose minor radius is the larger, so that its inner sheet bounds a spindle, as POV-Ray 3.8 draws it
/// (spec 7c, 3): what the spindle is to the solid is chosen, and normals of the inner sheet are those of that sheet.
/// Faces: 0 the outer sheet, 1 the inner one. It holds its surface, its inverse does not.
class SpindleTorus {
public:
    /// Union: the spindle is inside and its sheet drawn. Merge: the sheet is not drawn. Difference: the spindle is
    /// outside. Intersection: it is all there is.
    enum class Spindle : std::uint8_t { Union, Merge, Difference, Intersection };

    /// 0 < major < minor.
    SpindleTorus(double major, double minor, Spindle spindle) : torus_{major, minor, {}}, spindle_(spindle) {}

    void intersect(const Ray& ray, IntersectionList& out) const;
    bool contains(const glm::dvec3& p) const;
    bool contains_inverted(const glm::dvec3& p) const { return !contains(p); }
    glm::dvec3 gradient(const glm::dvec3& p, std::uint32_t face) const;
    glm::dvec2 uv(const glm::dvec3& p, std::uint32_t face) const { return torus_.uv(p, face); }
    Aabb bounds() const;

    static constexpr bool kSurface = false;
    static constexpr bool kClosed = true, kInverseClosed = false;
    bool reports_touches() const { return spindle_ == Spindle::Union; }

private:
    static constexpr std::uint32_t kOuter = 0, kInner = 1;

    bool in_spindle(double rho, double y) const;

    Torus torus_;
    Spindle spindle_;
};

}  // namespace csg
