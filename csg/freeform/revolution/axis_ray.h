#pragma once

#include "csg/base/types.h"
#include "numbers/lane_arithmetic.h"

#include <utility>

namespace csg {

/// What a ray sweeps about the local y axis: at height y it is sqrt(nearest^2 + ((y - foot) run / rise)^2) away from
/// it, so that the circle of radius r at that height lies outside of it where beyond(r, y) = rise^2 (r^2 - nearest^2) -
/// run^2 (y - foot)^2 > 0, and the ray meets the circle where that is 0. Level and upright rays are no special cases of
/// it: neither rise nor run is divided by. \tparam T double, or lanes with a ray each
template <class T>
struct AxisSweep {
    T rise, run;      ///< |cosine| and sine of the angle between ray and axis
    T nearest, foot;  ///< distance from the axis where the ray comes nearest to it, and the height there

    /// Of the circle of radius r (may be negative) at foot + above.
    T beyond(const T& r, const T& above) const
    {
        const T across = run * above;
        return rise * rise * (r - nearest) * (r + nearest) - across * across;
    }
};

/// A ray as seen from the local y axis.
template <class T>
class AxisRayOf : public AxisSweep<T> {
public:
    using Truth = lanes::Truth<T>;
    using AxisSweep<T>::rise, AxisSweep<T>::run, AxisSweep<T>::nearest, AxisSweep<T>::foot;

    /// From `o` in the direction of d.
    AxisRayOf(const T (&o)[3], const T (&d)[3])
    {
        length_ = lanes::root_of(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        for (int k = 0; k < 3; ++k) way_[k] = d[k] / length_;
        // From a far camera the numbers below would lose what decides about a tangent: the start is moved here with one
        // rounding.
        start_ = lanes::negated(o[0] * way_[0] + o[1] * way_[1] + o[2] * way_[2]) / length_;
        for (int k = 0; k < 3; ++k) origin_[k] = lanes::fused(start_, d[k], o[k]);
        const T &x = origin_[0], &y = origin_[1], &z = origin_[2], &dx = way_[0], &dy = way_[1], &dz = way_[2];
        rise = lanes::size_of(dy);
        run = lanes::root_of(dx * dx + dz * dz);
        const Truth leans = run > T(kUpright);
        const T zero(0.0);
        nearest = lanes::either(
            leans, [&] { return lanes::size_of(x * dz - z * dx) / run; },
            [&] { return lanes::root_of(x * x + z * z); });
        shift_ = lanes::either(
            leans, [&] { return lanes::negated(x * dx + z * dz) / (run * run); }, [&] { return zero; });
        run = lanes::choose(leans, run, zero);
        foot = y + shift_ * dy;
        nearest2_ = nearest * nearest;
    }

    /// False: nothing can be said of this ray.
    Truth valid() const
    {
        const T infinite(kInfinity);
        return length_ > T(0.0) && length_ < infinite && nearest < infinite && lanes::size_of(foot) < infinite;
    }
    /// It stays at one height: at most 2^-460 of it is upward, too little to be squared.
    Truth level() const { return !(rise > T(kLevel)); }
    Truth rising() const { return way_[1] > T(0.0); }

    /// beyond() of the radius' square.
    T beyond_square(const T& r2, const T& above) const
    {
        const T across = run * above;
        return rise * rise * (r2 - nearest2_) - across * across;
    }

    /// Ray parameter where a circle is met at height y; `below` the foot or not, which y tells too, but for its
    /// rounding.
    T at(const T& r, const T& y, const Truth& below) const
    {
        return at_square((r - nearest) * (r + nearest), y, below);
    }
    /// The same of r^2 - nearest^2.
    T at_square(const T& room, const T& y, const Truth& below) const
    {
        return lanes::either(
            tells(room),
            [&] {
                const T along = lanes::root_of(lanes::larger(room, T(0.0))) / run;
                const Truth against = lanes::differ(below, way_[1] < T(0.0));
                return start_ + (shift_ + lanes::choose(against, lanes::negated(along), along)) / length_;
            },
            [&] { return at_height(y); });
    }
    /// Whether at_square() goes by the radius: near the ray's own nearest point it says little, the height still does.
    Truth tells(const T& room) const { return !(rise > run || room < rise * rise * (room + nearest2_)); }
    /// Between them lies every crossing of a profile that rises or falls from one circle to the other, in height and in
    /// radius, on one side: the parameters of both by the same of the two.
    std::pair<T, T> between(const T& r0, const T& y0, const T& r1, const T& y1, const Truth& below) const
    {
        const T room0 = (r0 - nearest) * (r0 + nearest), room1 = (r1 - nearest) * (r1 + nearest);
        const Truth by_radius = tells(room0) && tells(room1);
        const auto place = [&](const T& room, const T& y) {
            return lanes::either(
                by_radius, [&] { return at_square(room, y, below); }, [&] { return at_height(y); });
        };
        const T a = place(room0, y0), b = place(room1, y1);
        return {sooner(lanes::smaller(a, b)), later(lanes::larger(a, b))};
    }
    /// Ray parameter at height y; not of level rays.
    T at_height(const T& y) const { return start_ + (y - origin_[1]) / way_[1] / length_; }
    /// A ray parameter, moved by more than the roundings of those that are told.
    T sooner(const T& t) const { return t - rounding(t); }
    T later(const T& t) const { return t + rounding(t); }
    /// The height at ray parameter t; infinite or no number at an infinite one.
    T height_at(const T& t) const { return origin_[1] + (t - start_) * length_ * way_[1]; }
    /// One step of Newton's from t and the place of a profile that it was found by, for both: the crossing of ray and
    /// profile. Tangents, where the step would be rounding alone, stay.
    T polished(const T& t, const T& radius, const T& height, const T& slope_radius, const T& slope_height) const
    {
        const T s = (t - start_) * length_;
        const T x = origin_[0] + s * way_[0], y = origin_[1] + s * way_[1], z = origin_[2] + s * way_[2];
        const T square = x * x + z * z - radius * radius, above = y - height;
        const T turn = (x * way_[0] + z * way_[2]) * slope_height, climb = radius * slope_radius * way_[1],
                determinant = turn - climb;
        const auto stay = [&] { return t; };
        const auto step = [&] {
            const T by = (radius * slope_radius * above - T(0.5) * slope_height * square) / determinant;
            return lanes::either(
                lanes::size_of(by) < T(kPolish) * (lanes::size_of(s) + lanes::size_of(radius)),
                [&] { return t + by / length_; }, stay);
        };
        return lanes::either(lanes::size_of(determinant) > T(kTangent) * (lanes::size_of(turn) + lanes::size_of(climb)),
                             step, stay);
    }
    /// Ray parameters within radius r of the axis; false: none.
    bool within(double r, double& from, double& to) const
    {
        if (!(r > nearest)) return false;
        const double half = std::sqrt((r - nearest) * (r + nearest)) / run;
        from = start_ + (shift_ - half) / length_;
        to = start_ + (shift_ + half) / length_;
        return true;
    }

private:
    static constexpr double kPolish = 1e-6;  // of the lengths: longer steps are none of rounding
    static constexpr double kRounding = 1e-12;
    static constexpr double kTangent = 1e-4;  // of the determinant's terms
    static constexpr double kUpright = 1e-100, kLevel = 0x1p-460;

    T rounding(const T& t) const { return T(kRounding) * (lanes::size_of(t) + lanes::size_of(start_)); }

    T origin_[3], way_[3];  // near the frame's origin; of unit length
    T length_, start_, shift_, nearest2_;
};

class AxisRay : public AxisRayOf<double> {
public:
    explicit AxisRay(const Ray& ray)
        : AxisRayOf({ray.origin.x, ray.origin.y, ray.origin.z}, {ray.direction.x, ray.direction.y, ray.direction.z})
    {}
};

/// Share of a full turn of a point about the y axis, 0 at x, 0.25 at z; 0 on the axis (spec 5b, 7.5). `widest`: largest
/// distance from it of any point of the solid.
double turn_about_y(const glm::dvec3& p, double widest);

/// Squared distance at which a point is taken to lie on the axis: POV-Ray's (spec 5b, 7.2), unless the solid is so
/// small that much of it would.
inline double on_axis(double widest) { return 1e-10 * glm::min(1.0, widest * widest); }

}  // namespace csg
