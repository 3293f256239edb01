#pragma once

#include "csg/solids/torus/torus.h"
#include "csg/packet/lanes/tile_rays.h"
#include "csg/packet/lanes/torus_looks.h"

#include <bit>

/// A torus against a tile of rays, in vector lanes.
namespace csg {

/// The pieces of the rays inside a torus, at most two a ray, as Torus::roots() pairs them. Rays that come near it are
/// packed, so that vectors are full.
class TorusEnds {
public:
    static constexpr int kPieces = 2;

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

    template <class Rays>
    void pack(const Torus& torus, const Rays& rays, RayMask mask, bool any_will_do)
    {
        const TorusLooks looks(torus);
        each_vector(mask, [&](int i) {
            for (int which = 0; which < 2; ++which) {
                lanes::beyond().store_aligned(entry_[which].data() + i);
                lanes::before().store_aligned(exit_[which].data() + i);
            }
            const lanes::Directions local = lanes::turned(torus.frame, rays.directions(i));
            const auto from = lanes::into(torus.frame, rays.origins(i));
            const TorusRays own{{Double(from.x), Double(from.y), Double(from.z)},
                                {local.x, local.y, local.z},
                                lanes::dot(local, local)};
            constexpr RayMask kVector = (RayMask{1} << lanes::kDoubles) - 1;
            RayMask near = lanes::mask(detail::near_torus(torus, own.o, own.d, own.square)) & (mask >> i) & kVector;
            if (near != 0 && any_will_do) {
                const auto [meets, misses] = looks.look(own, Double::load_aligned(rays.t_min.data() + i),
                                                        Double::load_aligned(rays.limit.data() + i),
                                                        static_cast<std::uint32_t>(near));
                sure |= RayMask{meets} << i;
                near &= ~(meets | misses);
            } else if (near != 0) {
                near &= ~lanes::mask(looks.passes_by(own));
            }
            if (near == 0) return;
            alignas(64) double part[6][lanes::kDoubles];
            for (int k = 0; k < 3; ++k) {
                own.o[k].store_aligned(part[k]);
                own.d[k].store_aligned(part[3 + k]);
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

    void solve(const Torus& torus, int at)
    {
        const auto load = [&](std::size_t k) { return Double::load_aligned(packed_[k].data() + at); };
        const Double o[3] = {load(0), load(1), load(2)}, d[3] = {load(3), load(4), load(5)};
        const auto course = detail::torus_course(torus, o, d, d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        const std::uint32_t possible = lanes::mask(course.possible);
        if (possible == 0) return;
        auto factors = detail::torus_by_factors(course.ray);
        const std::uint32_t safe = lanes::mask(factors.safe), two = lanes::mask(factors.two),
                            four = lanes::mask(factors.four);
        if ((four & possible) != 0) course.pair(factors.four, factors.roots);
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
