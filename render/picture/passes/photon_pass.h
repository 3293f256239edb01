#pragma once

#include "render/kernel/gather/indirect_light.h"
#include "render/picture/render.h"

namespace trace {

/// Shoots the scene's photons on all threads of `options`, or reads them from a file, and puts them in order. The same
/// photons in the same order for any number of threads. False: cancelled. Throws std::runtime_error where there are too
/// many of them, or a file fails.
bool find_photons(const plan::CompiledScene& scene, const RenderOptions& options, IndirectLight& out);

}  // namespace trace
