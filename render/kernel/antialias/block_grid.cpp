#include "render/kernel/antialias/block_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace trace {

void order_cells(int columns, int rows, bool in_order, AntialiasScratch& scratch)
{
    if (scratch.ordered_columns == columns && scratch.ordered_rows == rows) return;
    scratch.ordered_columns = columns;
    scratch.ordered_rows = rows;
    const auto spread = [](std::uint64_t v) {
        v = (v | v << 16) & 0x0000ffff0000ffffu;
        v = (v | v << 8) & 0x00ff00ff00ff00ffu;
        v = (v | v << 4) & 0x0f0f0f0f0f0f0f0fu;
        v = (v | v << 2) & 0x3333333333333333u;
        return (v | v << 1) & 0x5555555555555555u;
    };
    const auto across = static_cast<std::uint32_t>(columns);
    const auto key = [&](std::uint32_t cell) { return spread(cell / across) << 1 | spread(cell % across); };
    scratch.order.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    std::iota(scratch.order.begin(), scratch.order.end(), 0u);
    if (in_order) return;
    std::sort(scratch.order.begin(), scratch.order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
}

void trace_block_grid(const SampleGrid& grid, const SampleTracer& tracer, AntialiasScratch& scratch)
{
    BlockEdges& edges = scratch.edges;
    const auto columns = static_cast<std::size_t>(grid.columns), rows = static_cast<std::size_t>(grid.rows);
    std::vector<scene::Color>& colors = scratch.samples.colors;
    colors.resize(grid.count());
    if (tracer.in_order) return tracer.grid(grid, colors.data());
    const auto first = static_cast<std::size_t>(std::floor(grid.first.x + 1.0));  // a block's border is at -1
    if (edges.below.size() < first + columns) edges.below.resize(first + columns);
    const bool left = edges.right_colors.size() == rows && edges.right == grid.first;
    // The block on the left has replaced what was known below of the first column.
    const auto begin = edges.below.begin() + static_cast<std::ptrdiff_t>(first);
    const bool top = std::all_of(begin + (left ? 1 : 0), begin + grid.columns,
                                 [&](const BlockEdges::Below& at) { return at.row == grid.first.y; });
    if (!left && !top) {
        tracer.grid(grid, colors.data());
    } else {
        const std::size_t skipped_columns = left ? 1 : 0, skipped_rows = top ? 1 : 0;
        const SampleGrid rest{grid.first + SamplePosition(skipped_columns, skipped_rows),
                              grid.columns - static_cast<int>(skipped_columns),
                              grid.rows - static_cast<int>(skipped_rows)};
        tracer.grid(rest, colors.data() + skipped_rows * columns + skipped_columns, columns);
        if (top)
            for (std::size_t column = 0; column < columns; ++column) colors[column] = edges.below[first + column].color;
        if (left)
            for (std::size_t row = 0; row < rows; ++row) colors[row * columns] = edges.right_colors[row];
    }
    edges.right = grid.first + SamplePosition(grid.columns - 1, 0);
    edges.right_colors.resize(rows);
    for (std::size_t row = 0; row < rows; ++row) edges.right_colors[row] = colors[(row + 1) * columns - 1];
    for (std::size_t column = 0; column < columns; ++column)
        edges.below[first + column] = {grid.first.y + (grid.rows - 1), colors[(rows - 1) * columns + column]};
}

}  // namespace trace
