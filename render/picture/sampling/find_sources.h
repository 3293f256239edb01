#pragma once

#include "render/plan/compiled_scene.h"
#include "render/kernel/path/sources.h"

namespace trace::path {

/// What a scene has to aim at, for all paths of its picture. threads: 0 for all cores.
Sources find_sources(const plan::CompiledScene& scene, int threads);

}  // namespace trace::path
