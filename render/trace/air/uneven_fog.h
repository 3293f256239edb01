#pragma once

#include "render/trace/queue/hit_mask.h"
#include "render/trace/shade/shade_context.h"
#include "render/trace/shade/shade_lanes.h"

#include <array>

namespace trace {

/// All fogs over the lengths of rays, put behind what air they have already (spec 2, section 16).
void add_fogs(const Context& context, const csg::RayTile& rays, HitMask hits, const TileLanes& length,
              std::array<Air, csg::kTileRays>& air);

}  // namespace trace
