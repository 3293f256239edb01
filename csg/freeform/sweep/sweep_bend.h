#pragma once

#include "csg/freeform/sweep/sphere_sweep.h"
#include "numbers/safeguarded_newton.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace csg {

/// A line and the spheres of a cubic segment that bends little for its thickness: reach(u) is concave, and so much so
/// that m -+ sqrt(reach) have one extreme each. Then these are found without taking polynomials of degree 10 apart.
class SweepBend {
public:
    /// `aside`: Bezier points across the line, w the radius; `m`: along it; `reach`: Bernstein ordinates of
    /// radius^2 - aside^2, which are what applies() is told by.
    SweepBend(const std::array<glm::dvec4, 4>& aside, const std::array<double, 4>& m)
    {
        powers(aside, aside_);
        powers(m, m_);
    }

    /// From the second differences of ordinates, which bound the second derivatives.
    static bool applies(const std::array<double, 4>& m, const std::array<double, 7>& reach)
    {
        double bend = -kInfinity, most = reach[0];
        for (std::size_t i = 0; i < 5; ++i)
            bend = std::max(bend, 30.0 * (reach[i + 2] - 2.0 * reach[i + 1] + reach[i]));
        for (const double r : reach) most = std::max(most, r);
        const double sway = 6.0 * std::max(std::abs(m[2] - 2.0 * m[1] + m[0]), std::abs(m[3] - 2.0 * m[2] + m[1]));
        return bend < 0.0 && most > 0.0 && -bend > 2.0 * std::sqrt(most) * sway;
    }

    /// False: the line misses them all.
    bool ends(SweepEnd& in, SweepEnd& out) const
    {
        const double top = peak();
        const Place here = at(top);
        if (!(here.reach > 0.0)) return false;
        in = lowest(top, here, 1.0);
        out = lowest(top, here, -1.0);
        out.t = -out.t;
        return true;
    }

private:
    static constexpr double kClose = 1e-9;  ///< of the segment: the last of Newton's steps doubles its digits

    struct Place {
        double m, dm, ddm, reach, dreach, ddreach;
    };

    template <class T>
    static void powers(const std::array<T, 4>& b, std::array<T, 4>& c)
    {
        c = {b[0], 3.0 * (b[1] - b[0]), 3.0 * (b[0] - 2.0 * b[1] + b[2]), b[3] - 3.0 * b[2] + 3.0 * b[1] - b[0]};
    }

    Place at(double u) const
    {
        const auto& c = aside_;
        const glm::dvec4 v = ((c[3] * u + c[2]) * u + c[1]) * u + c[0], d = (3.0 * u * c[3] + 2.0 * c[2]) * u + c[1],
                         dd = 6.0 * u * c[3] + 2.0 * c[2];
        const auto minus = [](const glm::dvec4& a, const glm::dvec4& b) {
            return a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z;
        };
        return {((m_[3] * u + m_[2]) * u + m_[1]) * u + m_[0],
                (3.0 * u * m_[3] + 2.0 * m_[2]) * u + m_[1],
                6.0 * u * m_[3] + 2.0 * m_[2],
                minus(v, v),
                2.0 * minus(v, d),
                2.0 * (minus(d, d) + minus(v, dd))};
    }

    /// Where reach is largest: its slope only falls.
    double peak() const
    {
        const double low = 0.0, high = 1.0;
        const double at_low = at(low).dreach, at_high = at(high).dreach;
        if (at_low <= 0.0) return low;
        if (at_high >= 0.0) return high;
        const auto slope = [this](double u) {
            const Place here = at(u);
            return ValueAndSlope{here.dreach, here.ddreach};
        };
        return safeguarded_newton(slope, low, high, false, at_low / (at_low - at_high), {kClose, 0.0}, 60);
    }

    /// Least sign * m - sqrt(reach); twice the root times its derivative is 2 sign m' sqrt(reach) - reach', which
    /// changes its sign once where reach is positive.
    SweepEnd lowest(double top, const Place& summit, double sign) const
    {
        const auto rising = [&](const Place& p) { return 2.0 * sign * p.dm * std::sqrt(p.reach) - p.dreach > 0.0; };
        const bool left = rising(summit);
        const double low = left ? 0.0 : top, high = left ? top : 1.0;
        const double rim = left ? 0.0 : 1.0;
        const Place outer = at(rim);
        if (rim == top || (outer.reach > 0.0 && rising(outer) == left))
            return {sign * outer.m - std::sqrt(std::max(outer.reach, 0.0)), rim};
        // As if reach were a parabola and m a line.
        const double bend = -0.5 * summit.ddreach,
                     away = std::abs(summit.dm) * std::sqrt(summit.reach / (bend * (bend + summit.dm * summit.dm)));
        double u = left ? top - away : top + away;
        if (!(u > low && u < high)) u = 0.5 * (low + high);
        const auto slope = [&](double v) {
            const Place here = at(v);
            if (!(here.reach > 0.0)) return ValueAndSlope{left ? -1.0 : 1.0, 0.0};  // beyond the end: halved
            const double root = std::sqrt(here.reach);
            return ValueAndSlope{2.0 * sign * here.dm * root - here.dreach,
                                 2.0 * sign * here.ddm * root + sign * here.dm * here.dreach / root - here.ddreach};
        };
        u = safeguarded_newton(slope, low, high, true, u, {kClose, 0.0}, 60);
        const Place here = at(u);
        return {sign * here.m - std::sqrt(std::max(here.reach, 0.0)), u};
    }

    std::array<glm::dvec4, 4> aside_;
    std::array<double, 4> m_;
};

}  // namespace csg
