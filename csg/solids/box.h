#pragma once

#include "csg/solids/shared/common.h"

namespace csg {

/// Faces of a box: axis, and which side of it.
enum BoxFace : std::uint32_t { kMinX, kMaxX, kMinY, kMaxY, kMinZ, kMaxZ };

/// Slabs picked by the sign of the direction; an end that is NaN (origin on a slab's plane, direction within it)
/// keeps what was there, which makes the box closed. The two winning parameters are then divided out, so that a
/// plane or another box in the same place gives the same number to the last bit.
inline bool box_interval(const Ray& ray, const glm::dvec3& lower, const glm::dvec3& upper, Interval& out)
{
    double entry = -kInfinity, exit = kInfinity;
    int entry_axis = 0, exit_axis = 0;
    for (int i = 0; i < 3; ++i) {
        const double inverse = 1.0 / ray.direction[i];
        const bool backward = std::signbit(inverse);
        const double first = ((backward ? upper[i] : lower[i]) - ray.origin[i]) * inverse;
        const double last = ((backward ? lower[i] : upper[i]) - ray.origin[i]) * inverse;
        if (first > entry) entry = first, entry_axis = i;
        if (last < exit) exit = last, exit_axis = i;
    }
    if (!(entry <= exit) || entry == kInfinity || exit == -kInfinity) return false;
    const auto plane = [&](int axis, bool on_entry, double rough, std::uint32_t& face) {
        const bool forward = ray.direction[axis] > 0.0;
        const bool at_lower = forward == on_entry;
        face = static_cast<std::uint32_t>(2 * axis + (at_lower ? 0 : 1));
        const double exact = ((at_lower ? lower[axis] : upper[axis]) - ray.origin[axis]) / ray.direction[axis];
        return exact == exact ? exact : rough;
    };
    out.entry = plane(entry_axis, true, entry, out.entry_face);
    out.exit = plane(exit_axis, false, exit, out.exit_face);
    if (out.exit < out.entry) out.exit = out.entry;  // along an edge the division may swap them by a rounding
    return true;
}

inline glm::dvec3 box_normal(std::uint32_t face)
{
    glm::dvec3 n(0.0);
    n[static_cast<int>(face / 2 % 3)] = face % 2 == 0 ? -1.0 : 1.0;
    return n;
}

inline bool box_contains(const glm::dvec3& p, const glm::dvec3& lower, const glm::dvec3& upper)
{
    return p.x >= lower.x && p.x <= upper.x && p.y >= lower.y && p.y <= upper.y && p.z >= lower.z && p.z <= upper.z;
}

glm::dvec2 box_uv(const glm::dvec3& local, const glm::dvec3& lower, const glm::dvec3& upper, std::uint32_t face);

/// An axis-aligned box with sorted corners; may be flat. It holds its surface, its inverse does not.
struct Box {
    glm::dvec3 lower{0.0}, upper{1.0};

    bool interval(const Ray& ray, Interval& out) const { return box_interval(ray, lower, upper, out); }
    bool contains(const glm::dvec3& p) const { return box_contains(p, lower, upper); }
    bool contains_inverted(const glm::dvec3& p) const { return !contains(p); }
    glm::dvec3 normal(const glm::dvec3&, std::uint32_t face) const { return box_normal(face); }
    Aabb bounds() const { return padded({lower, upper}); }
    glm::dvec2 uv(const glm::dvec3& p, std::uint32_t face) const { return box_uv(p, lower, upper, face); }

    static constexpr bool kClosed = true, kInverseClosed = false;
};

/// A box under a transformation.
struct OrientedBox {
    glm::dvec3 lower{0.0}, upper{1.0};
    Transform frame;  ///< local to world

    bool interval(const Ray& ray, Interval& out) const
    {
        return box_interval(local_ray(frame, ray), lower, upper, out);
    }
    bool contains(const glm::dvec3& p) const { return box_contains(frame.inverse_point(p), lower, upper); }
    bool contains_inverted(const glm::dvec3& p) const { return !contains(p); }
    glm::dvec3 normal(const glm::dvec3&, std::uint32_t face) const { return unit_or_x(frame.normal(box_normal(face))); }
    Aabb bounds() const { return padded(transformed_box(frame, {lower, upper})); }
    glm::dvec2 uv(const glm::dvec3& p, std::uint32_t face) const
    {
        return box_uv(frame.inverse_point(p), lower, upper, face);
    }

    static constexpr bool kClosed = true, kInverseClosed = false;
};

}  // namespace csg
