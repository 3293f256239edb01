#pragma once

#include "render/plan/compiled_scene.h"

#include <vector>

namespace trace {

/// A block of pixels: columns [left, left + width), rows [top, top + height).
struct Block {
    int left = 0, top = 0, width = 0, height = 0;
};

/// The blocks of a picture, tiling the render window from its top left corner (spec 2, section 9).
std::vector<Block> blocks_of(const plan::Options& options);

}  // namespace trace
