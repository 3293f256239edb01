#pragma once

#include "render/scene/base/color.h"
#include "render/kernel/tile/geometry.h"

namespace trace {

class InteriorList;
struct Context;
struct RayState;

/// Colours of a tile of rays that have been traced: hits are shaded, misses see the sky. `transmit` of a colour is what
/// the background shows through (alpha output). rays.count colours are written.
/// \param first   what the rays inherit, all but the ray itself: a camera ray's start, or that of a ray that gathers
///                light. Rays that are gathered from within shading have a Context with Scratch::nested() of its own.
/// \param starts  what each ray starts inside of; null: all as `first`
void shade_tile(Context& context, const RayTile& rays, const HitTile& hits, const RayState& first,
                const InteriorList* starts, scene::Color* out);

}  // namespace trace
