#pragma once

#include "render/scene/color.h"
#include "render/trace/geometry.h"

namespace plan {
struct CompiledScene;
}

namespace trace {

class InteriorList;
struct Scratch;

/// Colours of a tile of camera rays: hits are shaded, misses see the sky. `transmit` of a colour is what the
/// background shows through (alpha output). rays.count colours are written. Recursion happens inside.
/// starts: what each ray starts inside of; null: all in the scene's eye.
void shade_tile(const plan::CompiledScene& scene, const RayTile& rays, const HitTile& hits, const InteriorList* starts,
                scene::Color* out, Scratch& scratch);

}  // namespace trace
