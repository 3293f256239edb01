#pragma once

#include "csg/types.h"

#include <cstdint>
#include <vector>

namespace csg {

/// What World reads: built by plan/, immutable afterwards.
struct WorldData {
    /// By SurfaceId: a shadow ray may stop at it for good (spec 3, 13.2).
    std::vector<std::uint8_t> surface_opaque;
};

}  // namespace csg
