#pragma once

#include "csg/base/hit.h"
#include "csg/world/world.h"
#include "render/plan/surface.h"

/// What shading asks of geometry, under the names that shading uses.
namespace trace {

using csg::Hit;
using csg::HitDetails;
using csg::HitTile;
using csg::kTileRays;
using csg::kTileSide;
using csg::RayTile;
using csg::Shadow;

}  // namespace trace
