#pragma once

#include "numbers/functions/lane_functions.h"
#include "render/kernel/tile/hit_mask.h"
#include "render/kernel/tile/tile_lanes.h"
#include "render/light/attenuation.h"

namespace trace {

/// What cones and distance leave of a light at one place, over the hits of a tile. Writes into `share` what is left at
/// the hits of `which`, which see the light so; others have any.
inline void attenuate(const light::Light& light, HitMask which, const TileHits& hits, const TileLight& seen,
                      TileLanes& share)
{
    using numbers::lanes::Double;
    constexpr HitMask kVector = (HitMask{1} << numbers::lanes::kDoubles) - 1;
    for (std::size_t i = 0; i < csg::kTileRays; i += numbers::lanes::kDoubles) {
        const auto in = static_cast<std::uint32_t>(which >> i & kVector);
        if (in == 0) continue;
        const auto load = [i](const TileLanes& lanes) { return Double::load_aligned(lanes.data() + i); };
        const LanePoints point{load(hits.x), load(hits.y), load(hits.z)},
            direction{load(seen.x), load(seen.y), load(seen.z)};
        light::attenuation(light, point, direction, load(seen.distance), numbers::lanes::lanes_of(in))
            .store_aligned(share.data() + i);
    }
}

}  // namespace trace
