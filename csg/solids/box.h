#pragma once

#include "csg/base/points.h"
#include "csg/solids/shared/common.h"

namespace csg {

/// Faces of a box: axis, and which side of it.
enum BoxFace : std::uint32_t { kMinX, kMaxX, kMinY, kMaxY, kMinZ, kMaxZ };

/// A box's corners, counted from where rays start.
template <class P>
struct BoxCorners {
    P lower, upper;

    BoxCorners(const glm::dvec3& low, const glm::dvec3& high, const P& origin)
        : lower(lanes::difference(low, origin)), upper(lanes::difference(high, origin))
    {}
};

/// 1 / d, by coordinates.
template <class D>
inline D reciprocal(const D& d)
{
    return {1.0 / d.x, 1.0 / d.y, 1.0 / d.z};
}

/// Slabs picked by the sign of the direction; an end that is NaN (origin on a slab's plane, direction within it)
/// keeps what was there, which makes the box closed. The two winning parameters are then divided out, so that a
/// plane or another box in the same place gives the same number to the last bit.
template <class P, class D, class I>
inline lanes::TruthOf<D> box_interval(const BoxCorners<P>& box, const D& d, const D& inverses, I& out)
{
    using V = lanes::NumberOf<D>;
    using Face = decltype(out.entry_face);
    V entry(-kInfinity), exit(kInfinity), first_plane(box.lower.x), last_plane(box.upper.x), first_slope = d.x,
                                                                                             last_slope = d.x;
    Face entry_face(0), exit_face(0);
    const auto axis = [&](const V& direction, const V& inverse, const V& lower, const V& upper, BoxFace low) {
        const lanes::Truth<V> backward = inverse < V(0.0);
        const V near = lanes::choose(backward, upper, lower), far = lanes::choose(backward, lower, upper);
        const V first = near * inverse, last = far * inverse;
        const lanes::Truth<V> later = first > entry, earlier = last < exit;
        const Face at_lower(low), at_upper(low + 1);
        entry = lanes::choose(later, first, entry);
        first_plane = lanes::choose(later, near, first_plane);
        first_slope = lanes::choose(later, direction, first_slope);
        entry_face = lanes::choose(later, lanes::choose(backward, at_upper, at_lower), entry_face);
        exit = lanes::choose(earlier, last, exit);
        last_plane = lanes::choose(earlier, far, last_plane);
        last_slope = lanes::choose(earlier, direction, last_slope);
        exit_face = lanes::choose(earlier, lanes::choose(backward, at_lower, at_upper), exit_face);
    };
    axis(d.x, inverses.x, V(box.lower.x), V(box.upper.x), kMinX);
    axis(d.y, inverses.y, V(box.lower.y), V(box.upper.y), kMinY);
    axis(d.z, inverses.z, V(box.lower.z), V(box.upper.z), kMinZ);
    const lanes::Truth<V> met = (entry <= exit) & (entry != V(kInfinity)) & (exit != V(-kInfinity));
    if (lanes::mask(met) == 0) return met;
    const V exact_entry = first_plane / first_slope, exact_exit = last_plane / last_slope;
    entry = lanes::choose(exact_entry == exact_entry, exact_entry, entry);
    exit = lanes::choose(exact_exit == exact_exit, exact_exit, exit);
    // Along an edge the division may swap them by a rounding.
    out = {entry, lanes::choose(exit < entry, entry, exit), entry_face, exit_face};
    return met;
}

inline glm::dvec3 box_normal(std::uint32_t face)
{
    glm::dvec3 n(0.0);
    n[static_cast<int>(face / 2 % 3)] = face % 2 == 0 ? -1.0 : 1.0;
    return n;
}

template <class P>
inline lanes::TruthOf<P> box_contains(const P& p, const glm::dvec3& lower, const glm::dvec3& upper)
{
    return (p.x >= lower.x) & (p.x <= upper.x) & (p.y >= lower.y) & (p.y <= upper.y) & (p.z >= lower.z) &
           (p.z <= upper.z);
}

glm::dvec2 box_uv(const glm::dvec3& local, const glm::dvec3& lower, const glm::dvec3& upper, std::uint32_t face);

/// An axis-aligned box with sorted corners; may be flat. It holds its surface, its inverse does not.
struct Box {
    glm::dvec3 lower{0.0}, upper{1.0};

    auto start(const auto& origin) const { return BoxCorners(lower, upper, origin); }
    template <class D, class I>
    lanes::TruthOf<D> interval(const auto& from, const D& direction, I& out) const
    {
        return box_interval(from, direction, reciprocal(direction), out);
    }
    bool interval(const Ray& ray, Interval& out) const { return interval(start(ray.origin), ray.direction, out); }
    template <class P>
    lanes::TruthOf<P> contains(const P& p) const
    {
        return box_contains(p, lower, upper);
    }
    template <class P>
    lanes::TruthOf<P> contains_inverted(const P& p) const
    {
        return !contains(p);
    }
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
        const Ray local = local_ray(frame, ray);
        return box_interval(BoxCorners(lower, upper, local.origin), local.direction, reciprocal(local.direction), out);
    }
    template <class P>
    lanes::TruthOf<P> contains(const P& p) const
    {
        return box_contains(lanes::into(frame, p), lower, upper);
    }
    template <class P>
    lanes::TruthOf<P> contains_inverted(const P& p) const
    {
        return !contains(p);
    }
    glm::dvec3 normal(const glm::dvec3&, std::uint32_t face) const { return unit_or_x(frame.normal(box_normal(face))); }
    Aabb bounds() const { return padded(transformed_box(frame, {lower, upper})); }
    glm::dvec2 uv(const glm::dvec3& p, std::uint32_t face) const
    {
        return box_uv(frame.inverse_point(p), lower, upper, face);
    }

    static constexpr bool kClosed = true, kInverseClosed = false;
};

}  // namespace csg
