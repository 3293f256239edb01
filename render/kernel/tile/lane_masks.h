#pragma once

#include "render/kernel/tile/hit_mask.h"

#include <array>

namespace trace {

/// A mask as a number a lane, 0 or 1: what loops over all hits choose by without a branch.
struct LaneMask {
    alignas(64) std::array<std::uint32_t, csg::kTileRays> of;

    explicit LaneMask(HitMask mask)
    {
        const auto low = static_cast<std::uint32_t>(mask), high = static_cast<std::uint32_t>(mask >> 32);
        for (std::uint32_t k = 0; k < 32; ++k) {
            of[k] = low >> k & 1u;
            of[k + 32] = high >> k & 1u;
        }
    }
    std::uint32_t operator[](std::size_t k) const { return of[k]; }
};

}  // namespace trace
