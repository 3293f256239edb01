#pragma once

#include "numbers/bytes.h"
#include "numbers/rounding.h"
#include "csg/bvh/bvh.h"
#include "csg/bvh/slab_axis.h"
#include "csg/packet/lanes/tile_rays.h"

#include <array>

/// Boxes against rays that form no beam.
namespace csg {

/// What RaySlabs is, for each ray of a tile.
template <class Rays>
class PacketSlabs {
public:
    explicit PacketSlabs(const Rays& rays) : rays_(rays)
    {
        take(0, rays.dx, rays.inverse_x);
        take(1, rays.dy, rays.inverse_y);
        take(2, rays.dz, rays.inverse_z);
        const auto count = static_cast<std::size_t>(rays.count);
        for (std::size_t k = 0; k < count; ++k) begin_[k] = rounded_down(rays.t_min[k]);
    }

    /// The rays of a mask that meet each of eight boxes (BvhNode::bounds); `near`: where the first of them does.
    /// Returns the boxes that any ray meets.
    std::uint32_t intersect(const float (&bounds)[6][8], RayMask asked, std::array<RayMask, 8>& rays, float* near) const
    {
        lanes::FloatPart nearest[lanes::kFloatParts];
        for (lanes::FloatPart& n : nearest) n = lanes::FloatPart(std::numeric_limits<float>::infinity());
        std::uint32_t any = 0;
        if ((asked & (asked - 1)) == 0) {
            any = add(bounds, static_cast<std::size_t>(std::countr_zero(asked)), nearest);
            rays.fill(asked);
        } else {
            alignas(64) std::array<std::uint8_t, kTileRays> met{};
            each_ray(asked, [&](std::size_t k) {
                const std::uint32_t mask = add(bounds, k, nearest);
                met[k] = static_cast<std::uint8_t>(mask);
                any |= mask;
            });
            if (any != 0) turn_over(met, rays);
        }
        for (int part = 0; part < lanes::kFloatParts; ++part)
            nearest[part].store_aligned(near + part * lanes::kFloatPart);
        return any;
    }

private:
    /// SlabAxis of every ray, each number in an array of its own: these loops go in lanes.
    struct Axis {
        alignas(64) std::array<float, kTileRays> near_origin, far_origin, near_inverse, far_inverse;
        alignas(64) std::array<std::int32_t, kTileRays> near_row, far_row;

        SlabAxis of(std::size_t k) const
        {
            SlabAxis out;
            out.near_row = near_row[k], out.far_row = far_row[k];
            out.near_origin = near_origin[k], out.far_origin = far_origin[k];
            out.near_inverse = near_inverse[k], out.far_inverse = far_inverse[k];
            return out;
        }
    };

    void take(int axis, const RayLanes& direction, const RayLanes& inverse)
    {
        Axis& to = axes_[axis];
        const auto count = static_cast<std::size_t>(rays_.count);
        for (std::size_t k = 0; k < count; ++k) {
            const SlabAxis at(axis, rays_.origin_of(k)[axis], inverse[k], std::signbit(direction[k]));
            to.near_row[k] = at.near_row, to.far_row[k] = at.far_row;
            to.near_origin[k] = at.near_origin, to.far_origin[k] = at.far_origin;
            to.near_inverse[k] = at.near_inverse, to.far_inverse[k] = at.far_inverse;
        }
    }

    /// The boxes that ray k meets; `nearest` comes down to where it does.
    std::uint32_t add(const float (&bounds)[6][8], std::size_t k, lanes::FloatPart (&nearest)[lanes::kFloatParts]) const
    {
        using lanes::FloatPart;
        const SlabAxis axes[3] = {axes_[0].of(k), axes_[1].of(k), axes_[2].of(k)};
        // No less than it: cheaper than rounding it up. (Below zero, as of rays that are done, no box is met.)
        const float limit = static_cast<float>(rays_.limit[k]) * (1.0f + 2.4e-7f);
        std::uint32_t mask = 0;
        for (int part = 0; part < lanes::kFloatParts; ++part) {
            const int at = part * lanes::kFloatPart;
            FloatPart first(begin_[k]), last(limit);
            for (const SlabAxis& axis : axes) axis.cut(bounds, at, first, last);
            const auto meets = first <= last;
            nearest[part] = xsimd::select(meets, xsimd::min(nearest[part], first), nearest[part]);
            mask |= lanes::mask(meets) << at;
        }
        return mask;
    }

    /// From boxes by ray to rays by box.
    void turn_over(const std::array<std::uint8_t, kTileRays>& met, std::array<RayMask, 8>& rays) const
    {
        rays.fill(0);
        for (int first = 0; first < rays_.count; first += 16)
            lanes::each_bit(met.data() + first, [&](std::size_t box, std::uint32_t found) {
                rays[box] |= static_cast<RayMask>(found) << first;
            });
    }

    const Rays& rays_;
    Axis axes_[3];
    alignas(64) std::array<float, kTileRays> begin_;
};

}  // namespace csg
