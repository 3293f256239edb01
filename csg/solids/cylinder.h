#pragma once

#include "csg/solids/shared/slab.h"
#include "csg/solids/shared/common.h"

namespace csg {

/// Faces of cylinders and cones.
enum TubeFace : std::uint32_t { kSide, kLowEnd, kHighEnd };

/// Frame of cylinders, cones and discs: scale (across, across, along), local z turned to `axis` about the shortest way
/// and moved to `base` (spec 5a, 3.3). `axis` has unit length.
Transform axis_frame(const glm::dvec3& base, const glm::dvec3& axis, double across, double along);

/// Radius 1 about z from z = 0 to z = 1, in its own frame. Without ends when open, but it bounds the same set. Closed
/// ones leave their surface out, open ones hold it (spec 5a, 2.4).
struct Cylinder {
    Transform frame;  ///< local to world
    bool open = false;

    bool interval(const Ray& ray, Interval& out) const
    {
        const Ray local = local_ray(frame, ray);
        if (!slab(local.origin.z, local.direction.z, 0.0, 1.0, out)) return false;
        out.entry_face = end_face(out.entry_face);
        out.exit_face = end_face(out.exit_face);
        const glm::dvec2 o(local.origin), d(local.direction);
        const double a = glm::dot(d, d);
        if (!(a > kAlong)) return glm::dot(o, o) <= 1.0 && out.entry > -kInfinity;
        // About the point nearest to the axis the roots are symmetric and nothing large cancels.
        const double inverse_a = 1.0 / a;
        const double foot_t = -glm::dot(o, d) * inverse_a;
        const glm::dvec2 foot = o + foot_t * d;
        const double below = 1.0 - glm::dot(foot, foot);
        if (!(below >= 0.0)) return false;
        const double correction = -glm::dot(foot, d) * inverse_a;
        const double half = std::sqrt(below * inverse_a);
        const Interval side{foot_t + (correction - half), foot_t + (correction + half), kSide, kSide};
        if (!(side.entry <= side.exit)) return false;
        return narrow(out, side);
    }
    bool contains(const glm::dvec3& p) const { return open ? grown(p, kSkin) : grown(p, -kSkin); }
    bool contains_inverted(const glm::dvec3& p) const { return !contains(p); }
    glm::dvec3 normal(const glm::dvec3& p, std::uint32_t face) const
    {
        if (face == kLowEnd || face == kHighEnd)
            return unit_or_x(frame.normal({0.0, 0.0, face == kLowEnd ? -1.0 : 1.0}));
        const glm::dvec3 local = frame.inverse_point(p);
        return unit_or_x(frame.normal({local.x, local.y, 0.0}));
    }
    Aabb bounds() const;

    /// POV-Ray's frame: base at the second point, z toward the first. The points must differ.
    static Cylinder make(const glm::dvec3& first, const glm::dvec3& second, double radius, bool open,
                         const Transform& t = {});

    /// Square of a direction across the axis that is none: the side lies beyond any distance.
    static constexpr double kAlong = 1e-300;
    /// Slack of POV-Ray's own inside test, in units of the canonical frame (spec 5a, 2.4).
    static constexpr double kSkin = 1e-10;

private:
    std::uint32_t end_face(std::uint32_t slab_face) const { return open ? kUndrawnFace : kLowEnd + slab_face; }
    bool grown(const glm::dvec3& p, double by) const
    {
        const glm::dvec3 l = frame.inverse_point(p);
        const double rim = 1.0 + by;
        return l.x * l.x + l.y * l.y < rim * rim && l.z > -by && l.z < 1.0 + by;
    }
};

}  // namespace csg
