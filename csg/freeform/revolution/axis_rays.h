#pragma once

#include "csg/base/hit.h"
#include "numbers/lane_arithmetic.h"
#include "csg/freeform/shared/intersection_list.h"
#include "csg/freeform/revolution/axis_ray.h"

#include <array>
#include <span>

/// Several rays as an AxisRay sees one, a ray a lane: the same operations in the same order. Compiled once per
/// instruction set.
namespace csg {

class AxisRays {
public:
    using Double = lanes::Double;
    using Bool = Double::batch_bool_type;
    using Mask = std::uint32_t;
    static constexpr std::size_t kWide = static_cast<std::size_t>(lanes::kDoubles);

    /// Of rays from these origins in these directions, a coordinate a row.
    AxisRays(const Double (&from)[3], const Double (&d)[3])
    {
        length_ = xsimd::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        way_ = {d[0] / length_, d[1] / length_, d[2] / length_};
        start_ = lanes::negated(from[0] * way_.x + from[1] * way_.y + from[2] * way_.z) / length_;
        origin_ = {lanes::fused(start_, d[0], from[0]), lanes::fused(start_, d[1], from[1]),
                   lanes::fused(start_, d[2], from[2])};
        rise = xsimd::abs(way_.y);
        run = xsimd::sqrt(way_.x * way_.x + way_.z * way_.z);
        const Bool leans = run > Double(AxisRay::kUpright);
        const Double zero(0.0);
        nearest = xsimd::select(leans, xsimd::abs(origin_.x * way_.z - origin_.z * way_.x) / run,
                                xsimd::sqrt(origin_.x * origin_.x + origin_.z * origin_.z));
        shift_ = xsimd::select(leans, lanes::negated(origin_.x * way_.x + origin_.z * way_.z) / (run * run), zero);
        run = xsimd::select(leans, run, zero);
        foot = origin_.y + shift_ * way_.y;
        nearest2_ = nearest * nearest;
    }

    Double rise, run, nearest, foot;

    Bool valid() const
    {
        const Double infinite(kInfinity);
        return (length_ > Double(0.0)) & (length_ < infinite) & (nearest < infinite) & (xsimd::abs(foot) < infinite);
    }
    Bool level() const { return !(rise > Double(AxisRay::kLevel)); }
    Bool rising() const { return way_.y > Double(0.0); }

    /// lathe_heights().
    void heights(const Double& from, const Double& to, double room, Double& low, Double& high) const
    {
        const Double about = Double(room) * (xsimd::abs(foot) + nearest);
        const Double below = height_at(from - rounding(from)), over = height_at(to + rounding(to));
        const Double least = smaller(below, over), most = larger(below, over);
        low = least - (about + Double(room) * xsimd::abs(least));
        high = most + (about + Double(room) * xsimd::abs(most));
    }
    Double beyond(const Double& r, const Double& above) const
    {
        const Double across = run * above;
        return rise * rise * (r - nearest) * (r + nearest) - across * across;
    }
    Double beyond_square(const Double& r2, const Double& above) const
    {
        const Double across = run * above;
        return rise * rise * (r2 - nearest2_) - across * across;
    }
    /// `side`: which lanes meet their circle below the foot.
    Double at(const Double& r, const Double& y, const Bool& below) const
    {
        return at_square((r - nearest) * (r + nearest), y, below);
    }
    Double at_square(const Double& room, const Double& y, const Bool& below) const
    {
        const Double along = xsimd::sqrt(larger(room, Double(0.0))) / run;
        const Bool falls = way_.y < Double(0.0), with = (below & falls) | ((!below) & (!falls));
        const Double by_radius = start_ + (shift_ + xsimd::select(with, along, lanes::negated(along))) / length_;
        return xsimd::select(tells(room), by_radius, at_height(y));
    }
    Bool tells(const Double& room) const { return !((rise > run) | (room < rise * rise * (room + nearest2_))); }
    void between(const Double& r0, const Double& y0, const Double& r1, const Double& y1, const Bool& below,
                 Double& least, Double& most) const
    {
        const Double room0 = (r0 - nearest) * (r0 + nearest), room1 = (r1 - nearest) * (r1 + nearest);
        const Bool by_radius = tells(room0) & tells(room1);
        const Double a = xsimd::select(by_radius, at_square(room0, y0, below), at_height(y0)),
                     b = xsimd::select(by_radius, at_square(room1, y1, below), at_height(y1));
        const Double first = smaller(a, b), last = larger(a, b);
        least = first - rounding(first);
        most = last + rounding(last);
    }
    Double at_height(const Double& y) const { return start_ + (y - origin_.y) / way_.y / length_; }
    Double polished(const Double& t, const Double& radius, const Double& height, const Double& slope_radius,
                    const Double& slope_height) const
    {
        const Double s = (t - start_) * length_;
        const Double x = origin_.x + s * way_.x, y = origin_.y + s * way_.y, z = origin_.z + s * way_.z;
        const Double square = x * x + z * z - radius * radius, above = y - height;
        const Double turn = (x * way_.x + z * way_.z) * slope_height, climb = radius * slope_radius * way_.y,
                     determinant = turn - climb;
        const Bool crosses = xsimd::abs(determinant) >
                             Double(AxisRay::kTangent) * (xsimd::abs(turn) + xsimd::abs(climb));
        const Double step = (radius * slope_radius * above - Double(0.5) * slope_height * square) / determinant;
        const Bool small = xsimd::abs(step) < Double(AxisRay::kPolish) * (xsimd::abs(s) + xsimd::abs(radius));
        return xsimd::select(crosses & small, t + step / length_, t);
    }

    static Double smaller(const Double& a, const Double& b) { return xsimd::select(b < a, b, a); }
    static Double larger(const Double& a, const Double& b) { return xsimd::select(a < b, b, a); }

private:
    struct Vector {
        Double x, y, z;
    };

    Double height_at(const Double& t) const { return origin_.y + (t - start_) * length_ * way_.y; }
    Double rounding(const Double& t) const { return Double(AxisRay::kRounding) * (xsimd::abs(t) + xsimd::abs(start_)); }

    Vector origin_, way_;
    Double length_, start_, shift_, nearest2_;
};

/// Rays by coordinates.
class LocalRays {
public:
    explicit LocalRays(std::span<const Ray> rays)
    {
        for (std::size_t k = 0; k < rays.size(); ++k)
            for (std::size_t i = 0; i < 3; ++i) {
                origin_[i][k] = rays[k].origin[static_cast<glm::length_t>(i)];
                way_[i][k] = rays[k].direction[static_cast<glm::length_t>(i)];
            }
    }
    AxisRays at(std::size_t k) const
    {
        const auto load = [&](const auto& of) { return AxisRays::Double::load_aligned(of.data() + k); };
        return AxisRays({load(origin_[0]), load(origin_[1]), load(origin_[2])},
                        {load(way_[0]), load(way_[1]), load(way_[2])});
    }

private:
    alignas(64) std::array<std::array<double, kTileRays>, 3> origin_{}, way_{};
};

/// Asks a solid of revolution for rays in lanes. Tile(shape, local, first ray, rays, out).run() answers as many as
/// there are lanes as shape.intersect() does.
template <class Tile, class Shape>
inline void intersect_in_lanes(const Shape& shape, std::span<const Ray> rays, IntersectionList* out)
{
    constexpr std::size_t kFewest = 3;  // fewer are told sooner one by one
    const LocalRays local(rays);
    for (std::size_t at = 0; at < rays.size(); at += AxisRays::kWide) {
        const std::size_t count = std::min(AxisRays::kWide, rays.size() - at);
        if (count < kFewest)
            for (std::size_t k = at; k < at + count; ++k) shape.intersect(rays[k], out[k]);
        else Tile(shape, local, at, rays.subspan(at, count), out + at).run();
    }
}

}  // namespace csg
