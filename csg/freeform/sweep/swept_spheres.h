#pragma once

#include "csg/freeform/shared/bernstein.h"
#include "csg/freeform/sweep/sphere_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace csg {

/// What a line has in the spheres of a segment: the sphere at u is met at m(u) -+ sqrt(reach(u)). Both by Bernstein
/// ordinates.
template <std::size_t count>
struct SweptSpheres {
    std::array<double, count> m;
    std::array<double, 2 * count - 1> reach;
    std::array<glm::dvec4, count> aside;  ///< control points across the line; w the radius
};

/// The ends of the union of these intervals over [a, b], where none is empty: they are at one of its ends, or where
/// m' = +-reach' / (2 sqrt(reach)).
template <std::size_t count>
class Extremes {
public:
    explicit Extremes(const SweptSpheres<count>& spheres) : spheres_(spheres)
    {
        const auto rate = derivative(spheres.reach);
        const auto way = derivative(spheres.m);
        auto turn = product(rate, rate);
        const auto both = product(product(way, way), spheres.reach);
        for (std::size_t i = 0; i < turn.size(); ++i) turn[i] -= 4.0 * both[i];
        const auto keep = [&](double u) {
            places_[count_++] = u;
            return count_ < places_.size();
        };
        each_change(turn, 0.0, 1.0, kHalvings, keep);
        changes_ = count_;
        // Where m' vanishes these are double.
        const auto [least, most] = std::minmax_element(way.begin(), way.end());
        if (!(*least > kAcross * *most || *most < kAcross * *least) && count_ < places_.size())
            each_change(rate, 0.0, 1.0, kHalvings, keep);
    }

    /// f(u) where an end of these intervals stands still, in no order.
    template <class F>
    void each_place(F&& f) const
    {
        for (std::size_t i = 0; i < count_; ++i) {
            double m = 0.0, way = 0.0;
            detail::casteljau(spheres_.m, places_[i], m, way);
            if (i < changes_ || std::abs(way) <= kStill) f(places_[i]);
        }
    }

    void find(double a, double b, SweepEnd& in, SweepEnd& out) const
    {
        in = {kInfinity, a};
        out = {-kInfinity, a};
        offer(a, in, out);
        offer(b, in, out);
        for (std::size_t i = 0; i < count_; ++i)
            if (places_[i] > a && places_[i] < b) offer(places_[i], in, out);
    }

private:
    static constexpr double kAcross = 1e-3;  ///< a derivative that varies by no more than this factor stays far from 0
    static constexpr double kStill = 1e-6;   ///< POV-Ray's for a segment that runs across the ray (spec 5b, 9.2)

    void offer(double u, SweepEnd& in, SweepEnd& out) const
    {
        double m = 0.0, reach = 0.0, unused = 0.0;
        detail::casteljau(spheres_.m, u, m, unused);
        detail::casteljau(spheres_.reach, u, reach, unused);
        const double half = std::sqrt(std::max(reach, 0.0));
        if (m - half < in.t) in = {m - half, u};
        if (m + half > out.t) out = {m + half, u};
    }

    const SweptSpheres<count>& spheres_;
    std::array<double, 6 * count> places_;
    std::size_t count_ = 0, changes_ = 0;
};

/// `direction` of unit length; from(k): control point k from a point of the line, and its radius.
template <std::size_t count, class From>
inline SweptSpheres<count> spheres_along(const glm::dvec3& direction, From&& from)
{
    SweptSpheres<count> spheres;
    for (std::size_t k = 0; k < count; ++k) {
        const glm::dvec4 c = from(k);
        spheres.m[k] = glm::dot(glm::dvec3(c), direction);
        spheres.aside[k] = c - glm::dvec4(spheres.m[k] * direction, 0.0);
    }
    spheres.reach = product(spheres.aside, spheres.aside, [](const glm::dvec4& a, const glm::dvec4& b) {
        return a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z;
    });
    return spheres;
}

}  // namespace csg
