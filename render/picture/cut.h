#pragma once

#include "render/picture/render.h"

#include <cstddef>
#include <vector>

namespace trace {

/// Cuts the blocks of a picture into parts that cost about as much: part i has the blocks [cut[i], cut[i + 1]). What a
/// block costs is guessed from the rays that single rays of a coarse grid ask for, so the cut is the same on every
/// machine. Empty: cancelled.
/// \param options  the passes' light, threads and instruction set are looked at
std::vector<std::size_t> cut_by_cost(const plan::CompiledScene& scene, const RenderOptions& options, int parts);

}  // namespace trace
