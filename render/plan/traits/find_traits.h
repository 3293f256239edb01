#pragma once

#include "render/plan/compiled_scene.h"

namespace plan {

/// Of a scene that is compiled but for them.
SceneTraits find_traits(const CompiledScene& scene);

}  // namespace plan
