#pragma once

#include "render/picture/render.h"

#include <cstdint>
#include <vector>

namespace trace {

/// What a ray costs at the places of a coarse grid over the window: the rays that it asks for, which are the same on
/// every machine. Empty: cancelled.
/// \param options  the passes' light, threads and instruction set are looked at
std::vector<double> coarse_costs(const plan::CompiledScene& scene, const RenderOptions& options);

/// Deals blocks out to parts that cost about as much: by block, the number of its part, from 0 on. The dearest first,
/// each to the part that has least, so neighbours, whose costs are guessed wrong alike, come to different parts.
/// \param costs  of coarse_costs() for the same picture. Throws std::runtime_error where they are those of another
std::vector<std::uint32_t> deal_by_cost(const Blocks& blocks, const std::vector<double>& costs, int parts);

}  // namespace trace
