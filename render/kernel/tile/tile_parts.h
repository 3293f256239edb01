#pragma once

#include "numbers/lanes.h"
#include "render/kernel/tile/hit_mask.h"

namespace trace {

/// f(first) for every register of a tile's hits that has one of these.
template <class F>
inline void each_part(HitMask hits, F&& f)
{
    constexpr HitMask kPart = (HitMask{1} << numbers::lanes::kFloatPart) - 1;
    for (std::size_t first = 0; first < csg::kTileRays; first += numbers::lanes::kFloatPart)
        if ((hits >> first & kPart) != 0) f(first);
}

}  // namespace trace
