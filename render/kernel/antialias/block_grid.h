#pragma once

#include "render/kernel/antialias/antialias.h"

/// What both methods of antialiasing ask of a whole block before they look at differences.
namespace trace {

/// Numbers of a grid's cells, row by row, such that neighbours in the list are neighbours in the picture: by the bits
/// of row and column in turn. Into scratch.order.
/// \param in_order  as they are
void order_cells(int columns, int rows, bool in_order, AntialiasScratch& scratch);

/// A block's grid of samples, into scratch.samples: its first column and row may be known from the blocks beside it.
void trace_block_grid(const SampleGrid& grid, const SampleTracer& tracer, AntialiasScratch& scratch);

}  // namespace trace
