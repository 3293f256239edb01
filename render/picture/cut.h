#pragma once

#include "render/picture/render.h"

#include <cstddef>
#include <vector>

namespace trace {

/// What a ray costs at the places of a coarse grid over the window: the rays that it asks for, which are the same on
/// every machine. Empty: cancelled.
/// \param options  the passes' light, threads and instruction set are looked at
std::vector<double> coarse_costs(const plan::CompiledScene& scene, const RenderOptions& options);

/// Cuts blocks into parts that cost about as much: part i has the blocks [cut[i], cut[i + 1]).
/// \param costs  of coarse_costs() for the same picture
std::vector<std::size_t> cut_by_cost(const Blocks& blocks, const std::vector<double>& costs, int parts);

}  // namespace trace
