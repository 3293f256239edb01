#pragma once

#include "csg/spans/span.h"
#include "numbers/lane_arithmetic.h"

namespace csg {

/// What Interval is, of a ray a lane: faces are numbers too.
template <class V>
struct EndsOf {
    V entry, exit, entry_face, exit_face;
};

/// The interval of a ray between two parallel planes, lower <= origin + t direction <= upper. Parallel rays are wholly
/// in or wholly out. Faces: 0 lower, 1 upper. False when empty.
/// \tparam I Interval, or what has its members for a ray a lane
template <class V, class I>
inline lanes::Truth<V> slab(const V& origin, const V& direction, double lower, double upper, I& out)
{
    using Face = decltype(out.entry_face);
    const V low(lower), high(upper), zero(0.0);
    const V a = (low - origin) / direction, b = (high - origin) / direction;
    const lanes::Truth<V> along = direction == zero, forward = direction > zero,
                          within = (origin >= low) & (origin <= high);
    out.entry = lanes::choose(along, V(-kInfinity), lanes::choose(forward, a, b));
    out.exit = lanes::choose(along, V(kInfinity), lanes::choose(forward, b, a));
    out.entry_face = lanes::choose(forward | along, Face(0), Face(1));
    out.exit_face = lanes::choose(forward, Face(1), Face(0));
    return lanes::choose(along, within, out.entry <= out.exit);
}

/// Keeps what both intervals hold; on equal ends the face of `a` stays. False when nothing is left.
template <class I>
inline auto narrow(I& a, const I& b)
{
    const auto later = b.entry > a.entry, earlier = b.exit < a.exit;
    a.entry = lanes::choose(later, b.entry, a.entry);
    a.entry_face = lanes::choose(later, b.entry_face, a.entry_face);
    a.exit = lanes::choose(earlier, b.exit, a.exit);
    a.exit_face = lanes::choose(earlier, b.exit_face, a.exit_face);
    return a.entry <= a.exit;
}

/// Keeps what a ray has in a box; faces count as those of a slab do, x first. False when nothing is left.
inline bool narrow(Interval& out, const Ray& ray, const glm::dvec3& lower, const glm::dvec3& upper)
{
    for (int k = 0; k < 3; ++k) {
        Interval side;
        if (!slab(ray.origin[k], ray.direction[k], lower[k], upper[k], side)) return false;
        side.entry_face += 2u * static_cast<std::uint32_t>(k);
        side.exit_face += 2u * static_cast<std::uint32_t>(k);
        if (!narrow(out, side)) return false;
    }
    return true;
}

}  // namespace csg
