#pragma once

#include "render/plan/compiled_scene.h"
#include "render/kernel/tile/block.h"

#include <cstddef>

namespace trace {

/// The blocks of a picture, tiling the render window from its top left corner, row by row (spec 2, section 9).
class Blocks {
public:
    Blocks() = default;
    explicit Blocks(const plan::Options& options);
    Blocks(const Block& window, int side);
    const Block& window() const { return window_; }
    std::size_t size() const { return per_row_ * rows_; }
    std::size_t rows() const { return rows_; }  ///< of blocks
    std::size_t per_row() const { return per_row_; }
    int side() const { return side_; }  ///< of a whole block
    Block operator[](std::size_t number) const;

private:
    Block window_;
    int side_ = 1;
    std::size_t per_row_ = 0, rows_ = 0;
};

}  // namespace trace
