#pragma once

#include "csg/base/rounding.h"
#include "csg/bvh/bvh.h"
#include "csg/bvh/slab_axis.h"
#include "csg/packet/tile_rays.h"

#include <array>

/// Boxes against rays that form no beam. Compiled once per instruction set.
namespace csg {

/// What RaySlabs is, for each ray of a tile.
template <class Rays>
class PacketSlabs {
public:
    explicit PacketSlabs(const Rays& rays) : rays_(rays)
    {
        const auto count = static_cast<std::size_t>(rays.count);
        const RayLanes* const direction[3] = {&rays.dx, &rays.dy, &rays.dz};
        const RayLanes* const inverse[3] = {&rays.inverse_x, &rays.inverse_y, &rays.inverse_z};
        for (int axis = 0; axis < 3; ++axis)
            for (std::size_t k = 0; k < count; ++k) {
                slabs_[k].axes[axis] =
                    SlabAxis(axis, rays.origin_of(k)[axis], (*inverse[axis])[k], std::signbit((*direction[axis])[k]));
            }
        for (std::size_t k = 0; k < count; ++k) slabs_[k].begin = rounded_down(rays.t_min[k]);
    }

    /// The rays of a mask that meet each of eight boxes (BvhNode::bounds); `near`: where the first of them does.
    /// Returns the boxes that any ray meets.
    std::uint32_t meet(const float (&bounds)[6][8], RayMask asked, std::array<RayMask, 8>& rays, float* near) const
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
    struct Slabs {
        SlabAxis axes[3];
        float begin;
    };

    /// The boxes that ray k meets; `nearest` comes down to where it does.
    std::uint32_t add(const float (&bounds)[6][8], std::size_t k, lanes::FloatPart (&nearest)[lanes::kFloatParts]) const
    {
        using lanes::FloatPart;
        const Slabs& ray = slabs_[k];
        // No less than it: cheaper than rounding it up. (Below zero, as of rays that are done, no box is met.)
        const float limit = static_cast<float>(rays_.limit[k]) * (1.0f + 2.4e-7f);
        std::uint32_t mask = 0;
        for (int part = 0; part < lanes::kFloatParts; ++part) {
            const int at = part * lanes::kFloatPart;
            FloatPart first(ray.begin), last(limit);
            for (const SlabAxis& axis : ray.axes) axis.cut(bounds, at, first, last);
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
        for (int first = 0; first < rays_.count; first += 16) {
            __m128i bytes = _mm_load_si128(reinterpret_cast<const __m128i*>(met.data() + first));
            for (std::size_t box = 8; box-- > 0; bytes = _mm_add_epi8(bytes, bytes))
                rays[box] |= static_cast<RayMask>(static_cast<std::uint32_t>(_mm_movemask_epi8(bytes))) << first;
        }
    }

    const Rays& rays_;
    std::array<Slabs, kTileRays> slabs_;
};

}  // namespace csg
