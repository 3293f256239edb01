#pragma once

#include "csg/hit.h"
#include "csg/world.h"
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

/// The bit of a kind of ray in csg::World's visibility masks.
constexpr std::uint8_t bit(plan::RayKind kind) { return static_cast<std::uint8_t>(1u << static_cast<unsigned>(kind)); }

}  // namespace trace
