#pragma once

#include "render/kernel/tile/hit_mask.h"
#include "render/kernel/context/context.h"
#include "render/kernel/tile/tile_lanes.h"

#include <array>

namespace trace {

/// All fogs over the lengths of rays, put behind what air they have already (spec 2, section 16).
void add_fogs(const Context& context, const csg::RayTile& rays, HitMask hits, const TileLanes& length,
              std::array<Air, csg::kTileRays>& air);

/// Share of light that fog lets pass over a length.
glm::vec3 fog_share(const Context& context, const csg::Ray& ray, double length);

}  // namespace trace
