#pragma once

namespace trace {

/// A block of pixels: columns [left, left + width), rows [top, top + height).
struct Block {
    int left = 0, top = 0, width = 0, height = 0;
};

}  // namespace trace
