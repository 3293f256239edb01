#pragma once

#include "csg/freeform/sweep/conic_prism.h"
#include "csg/solids/shared/slab.h"

namespace csg {

/// A ray's way between the heights of both ends, from the point of it nearest to the apex on. Seen from the apex it is
/// a straight line across the outline, and the plane of both cuts it where the ray passes a wall. Where the ray is
/// level with the apex it is infinitely far out on that line: outside. \tparam T double, or lanes with a ray each
template <class T>
struct ConicPrism::Course {
    using Truth = lanes::Truth<T>;

    T ox, oy, oz, dx, dy, dz;
    T shift;                   ///< from there to the given ray's parameter
    T entry, exit;             ///< between both ends
    T apex;                    ///< where the ray is level with it; never, if the ray is level
    T nearest, farthest;       ///< the stretch that is asked for
    Truth rises, apex_behind;  ///< the latter: no sooner than the exit
    Truth one_sided;           ///< the stretch is one piece of the straight line
    Truth through_apex;        ///< which makes it a point
    Truth asked;               ///< the others that there is something to be told of

    Course(const ConicPrism& prism, const T (&o)[3], const T (&d)[3], const T& from, const T& to)
        : dx(d[0]), dy(d[1]), dz(d[2]), low_(prism.low_), high_(prism.high_)
    {
        const T zero(0.0), infinite(kInfinity), square = dx * dx + dy * dy + dz * dz;
        shift = lanes::negated(o[0] * dx + o[1] * dy + o[2] * dz) / square;
        ox = o[0] + shift * dx, oy = o[1] + shift * dy, oz = o[2] + shift * dz;
        EndsOf<T> ends;
        const Truth between = slab(oy, dy, prism.low_, prism.high_, ends);
        const Truth met = square > zero && square < infinite && between;
        entry = ends.entry, exit = ends.exit;
        nx_ = oy * dz - dy * oz, ny_ = oz * dx - dz * ox, nz_ = ox * dy - dx * oy;
        through_apex = met && nx_ == zero && nz_ == zero;
        apex = lanes::negated(oy) / dy;
        rises = dy != zero;
        const bool both_sides = !(prism.low_ > 0.0 || prism.high_ < 0.0),
                   touches = prism.low_ == 0.0 || prism.high_ == 0.0;
        one_sided = Truth(!both_sides) || (rises && Truth(touches));
        nearest = lanes::larger<T>(entry, widened(from, -1.0) - shift);
        farthest = lanes::smaller<T>(exit, widened(to, 1.0) - shift);
        asked = met && !through_apex && !(nearest > farthest);
        apex_behind = rises && apex >= exit;
    }

    /// Seen from the apex.
    template <class Line>
    Line line() const
    {
        Line line;
        line.side = {nx_, nz_};
        line.level = lanes::negated(ny_);
        line.along = {lanes::negated(nz_), nx_};
        line.lo = lanes::either(
            one_sided, [&] { return lanes::negated(farthest_along(nearest, -1.0)); }, [] { return T(-kInfinity); });
        line.hi = lanes::either(
            one_sided, [&] { return farthest_along(farthest, 1.0); }, [] { return T(kInfinity); });
        return line;
    }
    /// How far along the line the ray is at t, a little more in the direction of `sign`: times `sign`. Infinite where
    /// it is level with the apex.
    T farthest_along(const T& t, double sign) const
    {
        const T y = lanes::smaller<T>(lanes::larger<T>(oy + t * dy, low_), high_);
        // More than the roundings of a wall's place.
        const T size_x = lanes::size_of(ox) + lanes::size_of(t * dx),
                size_z = lanes::size_of(oz) + lanes::size_of(t * dz);
        const T along = (lanes::negated(nz_) * (ox + t * dx) + nx_ * (oz + t * dz)) / y;
        const T room = lanes::size_of(nz_) * size_x + lanes::size_of(nx_) * size_z +
                       lanes::size_of(along) * (lanes::size_of(oy) + lanes::size_of(t * dy));
        const T found = T(sign) * along + T(1e-12) * room / lanes::size_of(y);
        return lanes::choose(lanes::size_of(t) < T(kInfinity) && y != T(0.0), found, T(kInfinity));
    }
    /// Where it passes the wall of the outline's point (x, z).
    T wall(const T& x, const T& z) const
    {
        const T gap_x = x * oy - ox, gap_z = z * oy - oz, closing_x = dx - x * dy, closing_z = dz - z * dy;
        return (gap_x * closing_x + gap_z * closing_z) / (closing_x * closing_x + closing_z * closing_z);
    }
    /// Before the stretch lies what the line runs through on its way here from infinity, where the ray is level with
    /// the apex.
    Truth before(const T& t) const
    {
        const Truth past = t > apex, sooner = t < nearest;
        return (one_sided && ((sooner && (!rises || apex_behind || past)) || (!sooner && apex_behind && past))) ||
               (!one_sided && rises && t < apex);
    }
    Truth holds(const T& t) const { return !one_sided || (t >= nearest && t <= farthest); }

    /// As of slab(): a level ray's are those of an interval without ends.
    static Interval within(double entry, double exit, double dy)
    {
        if (dy == 0.0) return {};
        return {entry, exit, dy > 0.0 ? 0u : 1u, dy > 0.0 ? 1u : 0u};
    }

private:
    static T widened(const T& end, double sign) { return end + T(sign * kWider) * lanes::size_of(end); }

    T low_, high_, nx_, ny_, nz_;
};

template <class Walls>
inline void ConicPrism::tell(double shift, const Interval& within, const Walls& walls, bool inside,
                             IntersectionList& out) const
{
    static_assert(kLow == 0 && kHigh == 1, "slab() counts its faces so");
    const std::uint32_t first = end_face(within.entry_face), last = end_face(within.exit_face);
    double in = -kInfinity;
    std::uint32_t in_face = kUndrawnFace;
    const auto piece = [&](double until, std::uint32_t face) {
        if (until < within.entry || in > within.exit || !(in <= until)) return true;
        const bool entered = in<within.entry, left = until> within.exit;
        return out.enter(shift + (entered ? within.entry : in), entered ? first : in_face) &&
               out.leave(shift + (left ? within.exit : until), left ? last : face);
    };
    for (const auto& wall : walls) {
        if (inside && !piece(wall.t, wall.face)) return;
        in = wall.t;
        in_face = wall.face;
        inside = !inside;
    }
    if (inside) piece(kInfinity, kUndrawnFace);
}

}  // namespace csg
