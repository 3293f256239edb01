#pragma once

#include "csg/base/hit.h"
#include "csg/packet/lanes/lane_interval.h"
#include "csg/packet/lanes/turned_rays.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

/// A tile of rays, ready for vector lanes.
namespace csg {

/// Rays go in groups of eight; places beyond the tile's count are dead.
inline constexpr int kRayGroup = 8;
using RayMask = std::uint64_t;  ///< bit i: ray i of the tile

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

/// Calls f(k) for every ray of a mask, the first one first.
template <class F>
inline void each_ray(RayMask mask, F&& f)
{
    for (; mask != 0; mask &= mask - 1) f(static_cast<std::size_t>(std::countr_zero(mask)));
}

/// The rays of groups first <= g < last.
inline RayMask rays_of_groups(int first, int last)
{
    const RayMask below = last * kRayGroup < kTileRays ? (RayMask{1} << (last * kRayGroup)) - 1 : ~RayMask{0};
    return below & ~((RayMask{1} << (first * kRayGroup)) - 1);
}

using RayLanes = std::array<double, kTileRays>;  ///< a number a ray

/// Copies a tile's numbers and fills the empty places of the last group.
inline void take_lanes(const RayTile& tile, const RayLanes& from, RayLanes& to, double empty)
{
    constexpr int kWhole = kTileRays;
    if (tile.count == kWhole) to = from;  // a copy of known size takes no call
    else std::copy_n(from.begin(), tile.count, to.begin());
    std::fill(to.begin() + tile.count, to.begin() + (tile.count + kRayGroup - 1) / kRayGroup * kRayGroup, empty);
}

/// Where the rays of a tile start: all of them in one point.
struct SharedOrigin {
    static constexpr bool kShared = true;
    glm::dvec3 origin;

    explicit SharedOrigin(const RayTile& tile) : origin(tile.ox[0], tile.oy[0], tile.oz[0]) {}
    glm::dvec3 origins(int) const { return origin; }
    glm::dvec3 origin_of(std::size_t) const { return origin; }
    /// The largest coordinates, by amount.
    glm::dvec3 widest() const { return glm::abs(origin); }
    /// The least and the most of dot(v, origin).
    std::pair<double, double> along(const glm::dvec3& v) const { return {glm::dot(v, origin), glm::dot(v, origin)}; }
};

/// Each ray of the tile in a point of its own.
struct OwnOrigins {
    static constexpr bool kShared = false;
    alignas(64) RayLanes ox, oy, oz;
    int places;

    OwnOrigins() {}  ///< not filled in
    explicit OwnOrigins(const RayTile& tile) : places((tile.count + kRayGroup - 1) / kRayGroup * kRayGroup)
    {
        take_lanes(tile, tile.ox, ox, tile.ox[0]);
        take_lanes(tile, tile.oy, oy, tile.oy[0]);
        take_lanes(tile, tile.oz, oz, tile.oz[0]);
    }
    lanes::Points origins(int i) const
    {
        using lanes::Double;
        return {Double::load_aligned(ox.data() + i), Double::load_aligned(oy.data() + i),
                Double::load_aligned(oz.data() + i)};
    }
    glm::dvec3 origin_of(std::size_t k) const { return {ox[k], oy[k], oz[k]}; }
    glm::dvec3 widest() const
    {
        const auto most = [&](const glm::dvec3& v) {
            const auto [least, last] = along(v);
            return std::max(-least, last);
        };
        return {most({1, 0, 0}), most({0, 1, 0}), most({0, 0, 1})};
    }
    std::pair<double, double> along(const glm::dvec3& v) const
    {
        using lanes::Double;
        Double least(kInfinity), most(-kInfinity);
        for (int i = 0; i < places; i += lanes::kDoubles) {
            const lanes::Points o = origins(i);
            const Double at = Double(v.x) * o.x + Double(v.y) * o.y + Double(v.z) * o.z;
            least = xsimd::min(least, at);
            most = xsimd::max(most, at);
        }
        return {lanes::lowest(least), -lanes::lowest(-most)};
    }
};

template <class Origins>
struct alignas(64) TileRays : Origins {
    using Lanes = RayLanes;
    alignas(64) Lanes dx, dy, dz;
    alignas(64) Lanes inverse_x, inverse_y, inverse_z;  ///< of the direction, clamped as RaySlabs does
    alignas(64) Lanes inverse_a;                        ///< 1 / dot(direction, direction)
    alignas(64) Lanes t_min, limit;                     ///< limit: nothing beyond matters; -infinity: the ray is done
    int count, groups;
    mutable TurnedRays<Origins> turned;  ///< where one solid after the other stands in the same space

    /// Not filled in.
    TileRays() requires(!Origins::kShared) {}
    explicit TileRays(const RayTile& tile)
        : Origins(tile), count(tile.count), groups((tile.count + kRayGroup - 1) / kRayGroup)
    {
        take_lanes(tile, tile.dx, dx, tile.dx[0]);
        take_lanes(tile, tile.dy, dy, tile.dy[0]);
        take_lanes(tile, tile.dz, dz, tile.dz[0]);
        take_lanes(tile, tile.t_min, t_min, tile.t_min[0]);
        take_lanes(tile, tile.t_max, limit, -kInfinity);
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
        return {Origins::origin_of(k), {dx[k], dy[k], dz[k]}};
    }

    lanes::Directions directions(int i) const
    {
        using lanes::Double;
        return {Double::load_aligned(dx.data() + i), Double::load_aligned(dy.data() + i),
                Double::load_aligned(dz.data() + i)};
    }

    RayMask all() const { return count < kTileRays ? (RayMask{1} << count) - 1 : ~RayMask{0}; }

    /// The farthest limit of groups first <= g < last; negative when all of them are done.
    double farthest(int first, int last) const
    {
        lanes::Double most(-kInfinity);
        for (int i = first * kRayGroup; i < last * kRayGroup; i += lanes::kDoubles)
            most = xsimd::max(most, lanes::Double::load_aligned(limit.data() + i));
        return -lanes::lowest(-most);
    }

    /// Which of the rays meet the box between t_min and limit.
    RayMask intersect(const glm::dvec3& lower, const glm::dvec3& upper, RayMask asked) const
    {
        using lanes::Double;
        // The box is rounded outward to single precision; this covers the roundings of the slabs in double.
        constexpr double kRoundedSlabs = 1.0 + 1e-12;
        RayMask mask = 0;
        each_vector(asked, [&](int i) {
            const auto from = Origins::origins(i);
            const auto low = lanes::difference(lower, from), high = lanes::difference(upper, from);
            const Double ix = Double::load_aligned(inverse_x.data() + i),
                         iy = Double::load_aligned(inverse_y.data() + i),
                         iz = Double::load_aligned(inverse_z.data() + i);
            const Double ax = Double(low.x) * ix, bx = Double(high.x) * ix;
            const Double ay = Double(low.y) * iy, by = Double(high.y) * iy;
            const Double az = Double(low.z) * iz, bz = Double(high.z) * iz;
            const Double near = xsimd::max(xsimd::max(xsimd::min(ax, bx), xsimd::min(ay, by)),
                                           xsimd::max(xsimd::min(az, bz), Double::load_aligned(t_min.data() + i)));
            const Double far = xsimd::min(xsimd::min(xsimd::max(ax, bx), xsimd::max(ay, by)), xsimd::max(az, bz));
            const Double end = xsimd::min(far * Double(kRoundedSlabs), Double::load_aligned(limit.data() + i));
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
