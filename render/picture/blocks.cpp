#include "render/picture/blocks.h"

#include <algorithm>

namespace trace {

namespace {

Block window_of(const plan::Options& options)
{
    const int right = options.end_column < 0 ? options.width - 1 : options.end_column;
    const int bottom = options.end_row < 0 ? options.height - 1 : options.end_row;
    return {options.start_column, options.start_row, right - options.start_column + 1, bottom - options.start_row + 1};
}

}  // namespace

Blocks::Blocks(const plan::Options& options) : Blocks(window_of(options), options.block_size) {}

Blocks::Blocks(const Block& window, int side)
    : window_(window), side_(std::max(1, std::min(side, std::max(window.width, window.height))))
{
    const auto count = [this](int length) {
        return length > 0 ? (static_cast<std::size_t>(length) - 1) / static_cast<std::size_t>(side_) + 1 : 0;
    };
    per_row_ = count(window_.width);
    rows_ = count(window_.height);
}

Block Blocks::operator[](std::size_t number) const
{
    const int left = static_cast<int>(number % per_row_) * side_, top = static_cast<int>(number / per_row_) * side_;
    return {window_.left + left, window_.top + top, std::min(side_, window_.width - left),
            std::min(side_, window_.height - top)};
}

}  // namespace trace
