#pragma once

#include "numbers/bits.h"
#include "csg/base/hit.h"

#include <bit>
#include <cstdint>

/// Some of a tile's hits.
namespace trace {

/// Bit k: hit k of the tile.
using HitMask = std::uint64_t;
static_assert(csg::kTileRays == 64);

/// f(k) for every hit of a mask, the first one first.
template <class F>
inline void for_each_hit(HitMask mask, F&& f)
{
    for (; mask != 0; mask &= mask - 1) f(static_cast<std::size_t>(std::countr_zero(mask)));
}

inline std::size_t first_hit(HitMask mask) { return static_cast<std::size_t>(std::countr_zero(mask)); }
inline bool has(HitMask mask, std::size_t k) { return (mask >> k & 1) != 0; }

/// f(k) for the first `count` places of a tile, rounded up to a multiple of 16, so that vector loops have no remainder.
template <class F>
inline void each_place(int count, F&& f)
{
    constexpr std::size_t kBlock = 16;
    static_assert(csg::kTileRays % kBlock == 0);
    for (std::size_t first = 0; first < static_cast<std::size_t>(count); first += kBlock)
        for (std::size_t k = first; k < first + kBlock; ++k) f(k);
}

/// Whether the hits are so few that a loop over them is faster than one over all places of the tile.
inline bool few(HitMask hits) { return std::popcount(hits) <= 8; }

using numbers::deposited;

/// Hits 0 <= k < count.
inline HitMask first_hits(int count) { return count < csg::kTileRays ? (HitMask{1} << count) - 1 : ~HitMask{0}; }

}  // namespace trace
