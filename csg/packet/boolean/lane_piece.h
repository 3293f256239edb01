#pragma once

#include "csg/packet/lanes/tile_rays.h"

namespace csg {

/// What a leaf of a boolean form holds of each of some rays: one of its intervals.
struct alignas(64) LanePiece {
    RayLanes t[2], face[2];  ///< entry, exit; an entry beyond the exit where there is none
    RayMask seen[2];         ///< the rays that see the end
    RayMask rays;            ///< those of the vectors that are filled in
    std::uint32_t leaf;
};

}  // namespace csg
