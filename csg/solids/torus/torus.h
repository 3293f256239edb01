#pragma once

#include "csg/base/points.h"
#include "csg/solids/shared/common.h"

namespace csg {

/// Axis y, y^2 + (sqrt(x^2 + z^2) - major)^2 <= minor^2, in its own frame. A spindle torus (minor > major) also draws
/// the inner sheet, inside the solid (spec 5a, 5.7). It holds its surface, its inverse does not.
struct Torus {
    double major = 1.0, minor = 0.25;  ///< both positive
    Transform frame;                   ///< local to world

    bool spindle() const { return minor > major; }

    /// Signed: negative inside. For a spindle negative on both sides of the inner sheet.
    template <class P>
    lanes::NumberOf<P> distance_like(const P& p) const
    {
        const auto rho = lanes::root_of(p.x * p.x + p.z * p.z) - major;
        return rho * rho + (p.y - minor) * (p.y + minor);
    }

    /// The crossings, at most 4: pairs of entry and exit in order. Of a spindle whose inner sheet is crossed the second
    /// pair is that of the inner sheet, within the first.
    int roots(const Ray& ray, double (&out)[4]) const;

    void intersect(const Ray& ray, SpanList& out) const;
    /// Parameters where the inner sheet of a spindle is crossed: drawn, but no end of a span.
    int inner_sheet(const Ray& ray, double (&out)[2]) const;

    template <class P>
    lanes::TruthOf<P> contains(const P& p) const
    {
        return distance_like(lanes::into(frame, p)) <= 0.0;
    }
    template <class P>
    lanes::TruthOf<P> contains_inverted(const P& p) const
    {
        return !contains(p);
    }
    glm::dvec3 normal(const glm::dvec3& p, std::uint32_t) const
    {
        const glm::dvec3 l = frame.inverse_point(p);
        const double rho = std::sqrt(l.x * l.x + l.z * l.z);
        const double k = rho > 0.0 ? 1.0 - major / rho : 1.0;
        return unit_or_x(frame.normal({k * l.x, l.y, k * l.z}));
    }
    Aabb bounds() const;
    glm::dvec2 uv(const glm::dvec3& p, std::uint32_t) const;  ///< spec 5a, 6

    static constexpr bool kClosed = true, kInverseClosed = false;
};

}  // namespace csg

#include "csg/solids/torus/torus_roots.h"
