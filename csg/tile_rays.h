#pragma once

#include "csg/hit.h"
#include "csg/lane_interval.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

/// A tile of rays from one point, ready for vector lanes. Compiled once per instruction set.
namespace csg {

/// Rays go in groups of eight; places beyond the tile's count are dead.
inline constexpr int kRayGroup = 8;
using RayMask = std::uint64_t;   ///< bit i: ray i of the tile

/// Calls f(i) for the first ray of every vector that has a ray in the mask.
template <class F>
inline void each_vector(RayMask mask, F&& f)
{
    constexpr RayMask kVector = (RayMask{1} << lanes::kDoubles) - 1;
    while (mask != 0) {
        const int i = std::countr_zero(mask) & ~(lanes::kDoubles - 1);
        mask &= ~(kVector << i);
        f(i);
    }
}

struct alignas(64) TileRays {
    using Lanes = std::array<double, kTileRays>;
    alignas(64) Lanes dx, dy, dz;
    alignas(64) Lanes inverse_x, inverse_y, inverse_z;   ///< of the direction, clamped as RaySlabs does
    alignas(64) Lanes inverse_a;                         ///< 1 / dot(direction, direction)
    alignas(64) Lanes t_min, limit;                      ///< limit: nothing beyond matters; -infinity: the ray is done
    glm::dvec3 origin;
    int count, groups;

    explicit TileRays(const RayTile& tile)
        : origin(tile.ox[0], tile.oy[0], tile.oz[0]), count(tile.count), groups((tile.count + kRayGroup - 1) / kRayGroup)
    {
        const auto take = [&](const Lanes& from, Lanes& to, double empty) {
            std::copy_n(from.begin(), count, to.begin());
            std::fill(to.begin() + count, to.begin() + groups * kRayGroup, empty);
        };
        take(tile.dx, dx, tile.dx[0]);
        take(tile.dy, dy, tile.dy[0]);
        take(tile.dz, dz, tile.dz[0]);
        take(tile.t_min, t_min, tile.t_min[0]);
        take(tile.t_max, limit, -kInfinity);
        for (int i = 0; i < groups * kRayGroup; i += lanes::kDoubles) {
            const auto x = lanes::Double::load_aligned(dx.data() + i), y = lanes::Double::load_aligned(dy.data() + i),
                       z = lanes::Double::load_aligned(dz.data() + i);
            inverse(x).store_aligned(inverse_x.data() + i);
            inverse(y).store_aligned(inverse_y.data() + i);
            inverse(z).store_aligned(inverse_z.data() + i);
            (lanes::Double(1.0) / (x * x + y * y + z * z)).store_aligned(inverse_a.data() + i);
        }
    }

    Ray ray(int i) const
    {
        const auto k = static_cast<std::size_t>(i);
        return {origin, {dx[k], dy[k], dz[k]}};
    }

    lanes::Directions directions(int i) const
    {
        using lanes::Double;
        return {Double::load_aligned(dx.data() + i), Double::load_aligned(dy.data() + i), Double::load_aligned(dz.data() + i)};
    }

    /// The rays of groups first <= g < last, and those of the tile.
    static RayMask mask_of(int first, int last)
    {
        const RayMask below = last * kRayGroup < kTileRays ? (RayMask{1} << (last * kRayGroup)) - 1 : ~RayMask{0};
        return below & ~((RayMask{1} << (first * kRayGroup)) - 1);
    }
    RayMask all() const { return count < kTileRays ? (RayMask{1} << count) - 1 : ~RayMask{0}; }

    /// The farthest limit of groups first <= g < last; negative when all of them are done.
    double farthest(int first, int last) const
    {
        lanes::Double most(-kInfinity);
        for (int i = first * kRayGroup; i < last * kRayGroup; i += lanes::kDoubles)
            most = xsimd::max(most, lanes::Double::load_aligned(limit.data() + i));
        alignas(64) double all[lanes::kDoubles];
        most.store_aligned(all);
        double farthest = all[0];
        for (const double t : all) farthest = t > farthest ? t : farthest;
        return farthest;
    }

    /// Which of the rays meet the box between t_min and limit.
    RayMask meet(const glm::dvec3& lower, const glm::dvec3& upper, RayMask asked) const
    {
        using lanes::Double;
        // The box is rounded outward to single precision; this covers the roundings of the slabs in double.
        constexpr double kWider = 1.0 + 1e-12;
        const glm::dvec3 low = lower - origin, high = upper - origin;
        RayMask mask = 0;
        each_vector(asked, [&](int i) {
            const Double ix = Double::load_aligned(inverse_x.data() + i), iy = Double::load_aligned(inverse_y.data() + i),
                         iz = Double::load_aligned(inverse_z.data() + i);
            const Double ax = Double(low.x) * ix, bx = Double(high.x) * ix;
            const Double ay = Double(low.y) * iy, by = Double(high.y) * iy;
            const Double az = Double(low.z) * iz, bz = Double(high.z) * iz;
            const Double near = xsimd::max(xsimd::max(xsimd::min(ax, bx), xsimd::min(ay, by)),
                                           xsimd::max(xsimd::min(az, bz), Double::load_aligned(t_min.data() + i)));
            const Double far = xsimd::min(xsimd::min(xsimd::max(ax, bx), xsimd::max(ay, by)), xsimd::max(az, bz));
            const Double end = xsimd::min(far * Double(kWider), Double::load_aligned(limit.data() + i));
            mask |= static_cast<RayMask>(lanes::mask(near <= end)) << i;
        });
        return mask & asked;
    }

private:
    static lanes::Double inverse(lanes::Double d)
    {
        const lanes::Double clamped = lanes::Double(1e30) | (d & lanes::Double(-0.0));
        return xsimd::select(xsimd::abs(d) < lanes::Double(1e-30), clamped, lanes::Double(1.0) / d);
    }
};

}  // namespace csg
