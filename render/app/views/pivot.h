#pragma once

#include "render/plan/compiled_scene.h"

namespace app {

/// From the eye to what the middle of the picture shows, or to the middle of the scene where it shows nothing.
double pivot_distance(const plan::CompiledScene& compiled);

}  // namespace app
