#pragma once

#include "csg/solids/torus/torus.h"
#include "csg/packet/tile_rays.h"

#include <algorithm>

/// A torus against a tile of rays, in vector lanes. Compiled once per instruction set.
namespace csg {

/// What the torus' solver asks of a kind of number.
struct LaneRays {
    using Number = lanes::Double;
    using Bool = lanes::Bool;
    static Number pick(Bool which, Number yes, Number no) { return xsimd::select(which, yes, no); }
    static Bool both(Bool a, Bool b) { return a & b; }
    static Bool either(Bool a, Bool b) { return a | b; }
    static bool any(Bool b) { return lanes::mask(b) != 0; }
    static Number sqrt(Number v) { return xsimd::sqrt(v); }
    static Number abs(Number v) { return xsimd::abs(v); }
    static Number cube_root_seed(Number v)
    {
        using Bits = xsimd::batch<std::uint64_t>;
        Bits third = xsimd::bitwise_cast<Bits>(v) >> 2;
        third += third >> 2;
        third += third >> 4;
        third += third >> 8;
        third += third >> 16;
        return xsimd::bitwise_cast<Number>(third + Bits(std::uint64_t{0x2a9f7893782da1ce}));
    }
};

/// The pieces of the rays inside a torus, at most two a ray. Rays that come near it are packed, so that vectors are
/// full.
class TorusEnds {
public:
    /// Of rays in the mask; the torus is one that detail::factors_serve(). any_will_do: of rays that surely meet it no
    /// more is told.
    template <class Rays>
    TorusEnds(const Torus& torus, const Rays& rays, RayMask mask, bool any_will_do = false)
    {
        pack(torus, rays, mask, any_will_do);
        for (int at = 0; at < count_; at += lanes::kDoubles) solve(torus, at);
    }

    /// Rays with a first piece, with a second one, and those to be asked one by one.
    RayMask met[2] = {0, 0}, unclear = 0;
    RayMask sure = 0;  ///< rays that meet it between t_min and limit, of which nothing else is told

    lanes::Intervals piece(int which, int i) const
    {
        lanes::Intervals out;
        out.entry = lanes::Double::load_aligned(entry_[which].data() + i);
        out.exit = lanes::Double::load_aligned(exit_[which].data() + i);
        out.met = out.entry <= out.exit;
        return out;
    }

private:
    using Double = lanes::Double;
    using Lanes = RayLanes;
    static constexpr double kSure = 1e-6;  // of squares of lengths

    template <class Rays>
    void pack(const Torus& torus, const Rays& rays, RayMask mask, bool any_will_do)
    {
        each_vector(mask, [&](int i) {
            for (int which = 0; which < 2; ++which) {
                lanes::beyond().store_aligned(entry_[which].data() + i);
                lanes::before().store_aligned(exit_[which].data() + i);
            }
            const lanes::Directions local = rays.directions(i).in(torus.frame);
            const auto from = lanes::into(torus.frame, rays.origins(i));
            const Double d[3] = {local.x, local.y, local.z}, o[3] = {Double(from.x), Double(from.y), Double(from.z)};
            constexpr RayMask kVector = (RayMask{1} << lanes::kDoubles) - 1;
            RayMask near = lanes::mask(detail::near_torus<LaneRays>(torus, o, d, local.square())) & (mask >> i) &
                           kVector;
            if (near != 0) near &= ~lanes::mask(passes_by(torus, o, d));
            if (near != 0 && any_will_do) {
                const RayMask through = near & lanes::mask(passes_through(torus, o, d, local.square(), rays, i));
                sure |= through << i;
                near &= ~through;
            }
            if (near == 0) return;
            alignas(64) double part[6][lanes::kDoubles];
            for (int k = 0; k < 3; ++k) {
                o[k].store_aligned(part[k]);
                d[k].store_aligned(part[3 + k]);
            }
            for (; near != 0; near &= near - 1) {
                const int lane = std::countr_zero(near);
                for (std::size_t k = 0; k < 6; ++k) packed_[k][static_cast<std::size_t>(count_)] = part[k][lane];
                ray_[static_cast<std::size_t>(count_++)] = static_cast<std::uint8_t>(i + lane);
            }
        });
        for (int i = count_; i % lanes::kDoubles != 0; ++i)
            for (Lanes& part : packed_) part[static_cast<std::size_t>(i)] = part[0];
    }

    static Double length2(const Double (&v)[3]) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

    /// Nearer than this places are known well enough for margins of kSure.
    static Double far(const Torus& torus) { return Double(1e12 * torus.minor * torus.minor); }

    /// Rays that surely miss it: between the planes that it touches above and below, they stay inside of its hole or
    /// outside of it all. How far a ray is from the axis is convex along it.
    static lanes::Bool passes_by(const Torus& torus, const Double (&o)[3], const Double (&d)[3])
    {
        const double hole = std::max(torus.major - torus.minor, 0.0), outer = torus.major + torus.minor;
        const Double inverse = Double(1.0) / d[1], height(torus.minor * (1.0 + kSure));
        const Double a = (Double(0.0) - height - o[1]) * inverse, b = (height - o[1]) * inverse;
        const auto from_axis = [&](Double t) {
            const Double x = o[0] + t * d[0], z = o[2] + t * d[2];
            return x * x + z * z;
        };
        const Double at_a = from_axis(a), at_b = from_axis(b), through(hole * hole - kSure * outer * outer);
        const Double foot = Double(0.0) - (o[0] * d[0] + o[2] * d[2]) / (d[0] * d[0] + d[2] * d[2]);
        const Double nearest = from_axis(xsimd::max(xsimd::min(a, b), xsimd::min(xsimd::max(a, b), foot)));
        return (length2(o) < far(torus)) &
               (((at_a < through) & (at_b < through)) | (nearest > Double(outer * outer * (1.0 + kSure))));
    }

    /// Rays that are well inside between t_min and limit, and outside at limit: looked for where they cross the plane
    /// of the ring, then where they come nearest to the point of the ring that is nearest to that place, and so on.
    /// Some are not found.
    template <class Rays>
    static lanes::Bool passes_through(const Torus& torus, const Double (&o)[3], const Double (&d)[3], Double square,
                                      const Rays& rays, int i)
    {
        constexpr int kLooks = 3;
        const double outer = torus.major + torus.minor;
        const Double t_min = Double::load_aligned(rays.t_min.data() + i),
                     limit = Double::load_aligned(rays.limit.data() + i);
        const auto at = [&](Double t, std::size_t k) { return o[k] + t * d[k]; };
        const Double end[3] = {at(limit, 0), at(limit, 1), at(limit, 2)};
        const lanes::Bool leaves = (length2(end) > Double(outer * outer * (1.0 + kSure))) &
                                   (length2(end) < far(torus)) & (length2(o) < far(torus));
        const Double tube(torus.minor * torus.minor * (1.0 - kSure)), major(torus.major);
        lanes::Bool inside(false);
        Double t = Double(0.0) - o[1] / d[1];
        for (int look = 0;; ++look) {
            const Double x = at(t, 0), y = at(t, 1), z = at(t, 2), rho = xsimd::sqrt(x * x + z * z),
                         apart = rho - major;
            inside = inside | ((apart * apart + y * y < tube) & (t > t_min) & (t < limit));
            if (look + 1 == kLooks || lanes::mask(leaves & !inside) == 0) return leaves & inside;
            const Double to_ring = major / rho;
            t = ((to_ring * x - o[0]) * d[0] - o[1] * d[1] + (to_ring * z - o[2]) * d[2]) / square;
        }
    }

    void solve(const Torus& torus, int at)
    {
        const auto load = [&](std::size_t k) { return Double::load_aligned(packed_[k].data() + at); };
        const Double o[3] = {load(0), load(1), load(2)}, d[3] = {load(3), load(4), load(5)};
        const auto course = detail::torus_course<LaneRays>(torus, o, d, d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        const std::uint32_t possible = lanes::mask(course.possible);
        if (possible == 0) return;
        const auto factors = detail::torus_by_factors(course.ray);
        const std::uint32_t safe = lanes::mask(factors.safe), two = lanes::mask(factors.two),
                            four = lanes::mask(factors.four);
        alignas(64) double t[4][lanes::kDoubles];
        if ((two & possible) != 0)
            for (int k = 0; k < (four != 0 ? 4 : 2); ++k) course.t(factors.roots[k]).store_aligned(t[k]);
        for (int lane = 0; lane < lanes::kDoubles && at + lane < count_; ++lane) {
            const std::uint32_t bit = 1u << lane;
            if ((possible & bit) == 0) continue;
            const std::size_t ray = ray_[static_cast<std::size_t>(at + lane)];
            if ((safe & bit) == 0) {
                unclear |= RayMask{1} << ray;
            } else {
                if ((two & bit) != 0) put(0, ray, t[0][lane], t[1][lane]);
                if ((four & bit) != 0) put(1, ray, t[2][lane], t[3][lane]);
            }
        }
    }

    void put(int which, std::size_t ray, double entry, double exit)
    {
        met[which] |= RayMask{1} << ray;
        entry_[which][ray] = entry;
        exit_[which][ray] = exit;
    }

    int count_ = 0;
    std::array<std::uint8_t, kTileRays> ray_;  ///< of each packed ray
    alignas(64) Lanes packed_[6];              ///< origins and directions in the torus' frame
    alignas(64) Lanes entry_[2], exit_[2];
};

}  // namespace csg
