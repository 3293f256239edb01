#pragma once

#include "csg/base/fused_at.h"
#include "csg/solids/shared/common.h"

#include <cmath>
#include <utility>

namespace csg {

/// A ray as seen from the local y axis: at height y it is sqrt(nearest^2 + ((y - foot) run / rise)^2) away from it, so
/// that the circle of radius r at that height lies outside of what the ray sweeps about the axis where
/// beyond(r, y) = rise^2 (r^2 - nearest^2) - run^2 (y - foot)^2 > 0, and the ray meets the circle where that is 0.
/// Level and upright rays are no special cases of it: neither rise nor run is divided by.
class AxisRay {
    friend class AxisRays;

public:
    explicit AxisRay(const Ray& ray)
    {
        const glm::dvec3& d = ray.direction;
        length_ = std::sqrt(glm::dot(d, d));
        const glm::dvec3 e = way_ = d / length_;
        // From a far camera the numbers below would lose what decides about a tangent: the start is moved here with one
        // rounding.
        start_ = -glm::dot(ray.origin, e) / length_;
        const glm::dvec3 o = origin_ = fused_at(ray, start_);
        rise = std::abs(e.y);
        run = std::sqrt(e.x * e.x + e.z * e.z);
        if (run > kUpright) {
            nearest = std::abs(o.x * e.z - o.z * e.x) / run;
            shift_ = -(o.x * e.x + o.z * e.z) / (run * run);
        } else {
            run = 0.0;
            nearest = std::sqrt(o.x * o.x + o.z * o.z);
            shift_ = 0.0;
        }
        foot = o.y + shift_ * e.y;
        nearest2_ = nearest * nearest;
    }

    double rise = 0.0, run = 0.0;  ///< |cosine| and sine of the angle between ray and axis
    double nearest = 0.0,
           foot = 0.0;  ///< distance from the axis where the ray comes nearest to it, and the height there

    /// False: nothing can be said of this ray.
    bool valid() const
    {
        return length_ > 0.0 && length_ < kInfinity && nearest < kInfinity && std::abs(foot) < kInfinity;
    }
    /// It stays at one height: at most 2^-460 of it is upward, too little to be squared.
    bool level() const { return !(rise > kLevel); }
    bool rising() const { return way_.y > 0.0; }

    /// Of the circle of radius r (may be negative) at foot + above.
    double beyond(double r, double above) const
    {
        const double across = run * above;
        return rise * rise * (r - nearest) * (r + nearest) - across * across;
    }
    /// The same of the radius' square.
    double beyond_square(double r2, double above) const
    {
        const double across = run * above;
        return rise * rise * (r2 - nearest2_) - across * across;
    }

    /// Ray parameter where a circle is met at height y; `side` < 0: below the foot, which y tells too, but for its
    /// rounding.
    double at(double r, double y, double side) const { return at_square((r - nearest) * (r + nearest), y, side); }
    /// The same of r^2 - nearest^2.
    double at_square(double room, double y, double side) const
    {
        if (!tells(room)) return at_height(y);
        const double along = std::sqrt(glm::max(room, 0.0)) / run;
        return start_ + (shift_ + ((side < 0.0) == (way_.y < 0.0) ? along : -along)) / length_;
    }
    /// Whether at_square() goes by the radius: near the ray's own nearest point it says little, the height still does.
    bool tells(double room) const { return !(rise > run || room < rise * rise * (room + nearest2_)); }
    /// Between them lies every crossing of a profile that rises or falls from one circle to the other, in height and in
    /// radius, on one side: the parameters of both by the same of the two.
    std::pair<double, double> between(double r0, double y0, double r1, double y1, double side) const
    {
        const double room0 = (r0 - nearest) * (r0 + nearest), room1 = (r1 - nearest) * (r1 + nearest);
        const bool by_radius = tells(room0) && tells(room1);
        const double a = by_radius ? at_square(room0, y0, side) : at_height(y0),
                     b = by_radius ? at_square(room1, y1, side) : at_height(y1);
        return {sooner(glm::min(a, b)), later(glm::max(a, b))};
    }
    /// Ray parameter at height y; not of level rays.
    double at_height(double y) const { return start_ + (y - origin_.y) / way_.y / length_; }
    /// A ray parameter, moved by more than the roundings of those that are told.
    double sooner(double t) const { return t - kRounding * (std::abs(t) + std::abs(start_)); }
    double later(double t) const { return t + kRounding * (std::abs(t) + std::abs(start_)); }
    /// The height at ray parameter t; infinite or no number at an infinite one.
    double height_at(double t) const { return origin_.y + (t - start_) * length_ * way_.y; }
    /// One step of Newton's from t and the place of a profile that it was found by, for both: the crossing of ray and
    /// profile. Tangents, where the step would be rounding alone, stay.
    double polished(double t, const glm::dvec2& place, const glm::dvec2& slope) const
    {
        const double s = (t - start_) * length_;
        const glm::dvec3 p = origin_ + s * way_;
        const double square = p.x * p.x + p.z * p.z - place.x * place.x, height = p.y - place.y;
        const double turn = (p.x * way_.x + p.z * way_.z) * slope.y, climb = place.x * slope.x * way_.y,
                     determinant = turn - climb;
        if (!(std::abs(determinant) > kTangent * (std::abs(turn) + std::abs(climb)))) return t;
        const double step = (place.x * slope.x * height - 0.5 * slope.y * square) / determinant;
        return std::abs(step) < kPolish * (std::abs(s) + std::abs(place.x)) ? t + step / length_ : t;
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

    glm::dvec3 origin_, way_;  // near the frame's origin; of unit length
    double length_ = 0.0, start_ = 0.0, shift_ = 0.0, nearest2_ = 0.0;
};

/// Share of a full turn of a point about the y axis, 0 at x, 0.25 at z; 0 on the axis (spec 5b, 7.5). `widest`: largest
/// distance from it of any point of the solid.
double turn_about_y(const glm::dvec3& p, double widest);

/// Squared distance at which a point is taken to lie on the axis: POV-Ray's (spec 5b, 7.2), unless the solid is so
/// small that much of it would.
inline double on_axis(double widest) { return 1e-10 * glm::min(1.0, widest * widest); }

}  // namespace csg
