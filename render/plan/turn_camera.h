#pragma once

#include "render/plan/compiled_scene.h"

namespace plan {

/// Another camera in the place of the one that the scene was compiled with: the scene is as if it had been compiled
/// with it. Neither of them has a mesh, functions, a normal or a bokeh, which are planned with textures.
void turn_camera(CompiledScene& scene, const scene::Camera& camera);

}  // namespace plan
