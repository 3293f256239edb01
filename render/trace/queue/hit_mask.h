#pragma once

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

/// Hits 0 <= k < count.
inline HitMask first_hits(int count) { return count < csg::kTileRays ? (HitMask{1} << count) - 1 : ~HitMask{0}; }

}  // namespace trace
