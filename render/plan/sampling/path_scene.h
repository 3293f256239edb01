#pragma once

#include "render/plan/compiled_scene.h"

namespace plan {

/// Leaves out of a description what stands for light that the path tracer finds itself: radiosity, photons, light below
/// surfaces, and, as with radiosity since 3.7, ambient (docs/path_tracing.md).
void prepare_for_paths(scene::Description& description);

/// Whether anything of the scene gives light that a path may find: a lamp, a sky, a finish that glows.
bool has_light(const CompiledScene& scene);

}  // namespace plan
