#pragma once

#include "render/kernel/light/direct_batch.h"
#include "render/kernel/context/segment_tile.h"

namespace trace {

/// Adds light from below the surface to the rows of a tile whose finishes ask for it (RowPage::gained).
void add_subsurface_light(Context& context, const SegmentTile& tile, DirectBatch& batch);

}  // namespace trace
