#pragma once

#include "csg/packet/lanes/tile_rays.h"

namespace csg {

/// What a leaf of a boolean form holds of each of some rays: one of its intervals.
struct alignas(64) LanePiece {
    RayLanes t[2], face[2];  ///< entry, exit; an entry beyond the exit where there is none
    RayMask seen[2];         ///< the rays that see the end
    RayMask rays;            ///< those of the vectors that are filled in
    std::uint32_t leaf;

    /// The interval of one ray; the first of a vector makes the others empty.
    void put(std::size_t ray, double in, std::uint32_t in_face, double out, std::uint32_t out_face)
    {
        constexpr std::size_t kLanes = lanes::kDoubles;
        if ((rays >> ray & 1) == 0) {
            const std::size_t first = ray / kLanes * kLanes;
            rays |= ((RayMask{1} << kLanes) - 1) << first;
            lanes::beyond().store_aligned(&t[0][first]);
            lanes::before().store_aligned(&t[1][first]);
        }
        t[0][ray] = in;
        t[1][ray] = out;
        face[0][ray] = in_face;
        face[1][ray] = out_face;
    }
};

}  // namespace csg
