#pragma once

#include "render/kernel/context/segment_tile.h"

namespace trace {

/// What rays of a tile see that meet nothing (spec 2, sections 14 and 15): out[k] for each of them.
void sky_colors(const Context& context, const SegmentTile& tile, HitMask missed, scene::Color* out);

/// The same of one ray.
/// \param mirrored  it is no camera ray
scene::Color sky_color(const Context& context, const csg::Ray& ray, bool mirrored);

}  // namespace trace
