#pragma once

#include "csg/solids/shared/common.h"

namespace csg {

/// The half-space dot(normal, p) <= offset: the inside of a POV-Ray `plane`. Unbounded, so its spans may begin at
/// -infinity or end at +infinity. It and its inverse both hold the surface.
struct Plane {
    glm::dvec3 normal_out{0.0, 1.0, 0.0};  ///< points out of the solid; unit length
    double offset = 0.0;                   ///< distance from the origin along the normal, scene units

    bool interval(const Ray& ray, Interval& out) const
    {
        const double closing = glm::dot(normal_out, ray.direction);      // < 0: the ray is going in
        const double depth = offset - glm::dot(normal_out, ray.origin);  // > 0: it starts inside
        out = Interval{};
        // Parallel: wholly in or wholly out. Nearly parallel needs no tolerance: it crosses, far away.
        if (closing == 0.0) return depth >= 0.0;
        const double t = depth / closing;
        (closing < 0.0 ? out.entry : out.exit) = t;
        return t > -kInfinity && t < kInfinity ? true : depth >= 0.0;
    }
    /// Slack of POV-Ray's own test, an absolute distance (spec 5a, 2.4).
    static constexpr double kSkin = 1e-10;
    bool contains(const glm::dvec3& p) const { return glm::dot(normal_out, p) - offset < kSkin; }
    bool contains_inverted(const glm::dvec3& p) const { return offset - glm::dot(normal_out, p) < kSkin; }
    glm::dvec3 normal(const glm::dvec3&, std::uint32_t) const { return normal_out; }
    Aabb bounds() const;  ///< bounded on one side where the normal is an axis

    /// This half-space moved by `t`.
    Plane transformed(const Transform& t) const;

    static constexpr bool kClosed = true, kInverseClosed = true;
};

}  // namespace csg
