#pragma once

#include "csg/packet/lanes/lane_interval.h"
#include "csg/solids/torus/torus.h"

#include <algorithm>

/// What is known of rays and a torus from a few looks, before its quartic is solved.
namespace csg {

/// Rays in the torus' own frame, a vector of them.
struct TorusRays {
    using Double = lanes::Double;

    Double o[3], d[3];
    Double square;  ///< of |d|

    Double at(Double t, int k) const { return o[k] + t * d[k]; }
    /// The square of their distance from the axis is convex.
    Double from_axis(Double t) const
    {
        const Double x = at(t, 0), z = at(t, 2);
        return x * x + z * z;
    }
    static Double length2(const Double (&v)[3]) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }
};

/// Looks for rays that surely miss a torus and for those that surely meet it.
class TorusLooks {
    using Double = lanes::Double;
    using Bool = lanes::Bool;

public:
    explicit TorusLooks(const Torus& torus)
        : major_(torus.major), minor_(torus.minor), outer_(major_ + minor_), hole_(std::max(major_ - minor_, 0.0)),
          most_share_(major_ / hole_), far_(1e12 * minor_ * minor_)
    {}

    /// Rays that surely miss it: between the planes that it touches above and below, they stay inside of its hole or
    /// outside of it all.
    Bool passes_by(const TorusRays& rays) const
    {
        const Double inverse = Double(1.0) / rays.d[1], height(minor_ * (1.0 + kSure));
        const Double a = (Double(0.0) - height - rays.o[1]) * inverse, b = (height - rays.o[1]) * inverse;
        const Double foot = Double(0.0) - (rays.o[0] * rays.d[0] + rays.o[2] * rays.d[2]) /
                                              (rays.d[0] * rays.d[0] + rays.d[2] * rays.d[2]);
        const Double nearest = rays.from_axis(xsimd::max(xsimd::min(a, b), xsimd::min(xsimd::max(a, b), foot)));
        const Double through(hole_ * hole_ - kSure * outer_ * outer_);
        return (TorusRays::length2(rays.o) < Double(far_)) &
               (((rays.from_axis(a) < through) & (rays.from_axis(b) < through)) |
                (nearest > Double(outer_ * outer_ * (1.0 + kSure))));
    }

    /// Bits of the lanes that surely meet it between t_min and limit, and of those that surely don't from t_min on.
    struct Known {
        std::uint32_t meets = 0, misses = 0;
    };

    /// For the lanes of the mask. Looks at where rays cross the plane of the ring, and then at where Newton's method
    /// has them nearest to the ring; first at t_min if one begins close by, for it may leave the torus itself.
    ///
    /// The square of the distance from the ring less minor^2 is f = |p|^2 + major^2 - minor^2 - 2 major sqrt(Q), with
    /// |p|^2 and Q = x^2 + z^2 of the second degree in t. The root is at most (Q / s + s) / 2 for any s > 0, so f lies
    /// above a parabola, which touches it where s is the root. A ray meets the torus that has f < 0 between t_min and
    /// limit and ends outside; it misses where the parabola is positive from t_min on. As no point of the torus has a
    /// root below the radius of its hole, s needs to be no smaller.
    Known look(const TorusRays& rays, Double t_min, Double limit, std::uint32_t asked) const
    {
        constexpr int kLooks = 4;
        const Double end[3] = {rays.at(limit, 0), rays.at(limit, 1), rays.at(limit, 2)};
        const Double zero(0.0), from2 = TorusRays::length2(rays.o), end2 = TorusRays::length2(end),
                                level = rays.d[0] * rays.d[0] + rays.d[2] * rays.d[2];
        const Bool known = from2 < Double(far_),
                   leaves = known & (end2 > Double(outer_ * outer_ * (1.0 + kSure))) & (end2 < Double(far_));
        const Double deep(-kSure * minor_ * minor_), clear(kSure * outer_ * outer_), wide(kWide * outer_ * outer_);
        Known out;
        if ((asked & lanes::mask(from2 < Double(outer_ * outer_))) != 0) {
            const Place start(*this, rays, level, t_min);
            const Double above = start.bound - Double(kOwn) * (from2 + Double(outer_ * outer_));
            out.misses |= asked & lanes::mask((start.bend > zero) & (above > zero) & (start.slope > zero) & known);
        }
        Double t = zero - rays.o[1] / rays.d[1];
        for (int look = 1; (asked &= ~(out.meets | out.misses)) != 0; ++look) {
            const Place at(*this, rays, level, t);
            out.meets |= asked & lanes::mask((at.f < deep) & (t > t_min) & (t < limit) & leaves);
            const Double above = at.bound - clear;
            out.misses |= asked & lanes::mask((at.bend > zero) & (above > zero) & (above < wide) &
                                              (at.slope * at.slope < at.bend * above) & known);
            if (look == kLooks) break;
            t = at.nearer(rays, level);
        }
        return out;
    }

private:
    static constexpr double kSure = 1e-6;  ///< of squares of lengths
    static constexpr double kOwn = 1e-12;  ///< the same where a ray begins: the rounding of its place alone
    static constexpr double kWide = 1e6;   ///< beyond it a parabola's discriminant is rounded by more than 1e-10

    /// A place of the rays: f there, and the parabola bound + 2 slope (u - t) + bend (u - t)^2 below f(u).
    struct Place {
        Double t, pull, turn, flat, lift, f, bound, slope, bend;

        Place(const TorusLooks& torus, const TorusRays& rays, Double level, Double where) : t(where)
        {
            const Double x = rays.at(t, 0), y = rays.at(t, 1), z = rays.at(t, 2), rho = xsimd::sqrt(x * x + z * z),
                         inverse = Double(1.0) / rho, major(torus.major_), hole(torus.hole_);
            flat = x * rays.d[0] + z * rays.d[2];
            lift = y * rays.d[1];
            pull = major * inverse;
            turn = flat * inverse;
            const Double apart = rho - major;
            f = apart * apart + y * y - Double(torus.minor_ * torus.minor_);
            // s is rho, or the radius of the hole where that is more.
            const Double share = xsimd::min(pull, Double(torus.most_share_)), gap = xsimd::max(hole - rho, Double(0.0));
            bound = f - share * gap * gap;
            slope = flat + lift - share * flat;
            bend = rays.square - share * level;
        }

        /// By a step of Newton's method for the least f, or a shorter one that surely lessens it.
        Double nearer(const TorusRays& rays, Double level) const
        {
            constexpr double kBent = 0.1;  // where f bends less, its step would leave the torus behind
            const Double curve = rays.square - pull * (level - turn * turn);
            return t -
                   (flat + lift - pull * flat) / xsimd::select(curve > Double(kBent) * rays.square, curve, rays.square);
        }
    };

    double major_, minor_, outer_, hole_;
    double most_share_;  ///< major over the radius of the hole
    double far_;         ///< nearer than its root, places are known well enough for kSure
};

}  // namespace csg
