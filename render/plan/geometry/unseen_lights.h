#pragma once

#include "render/plan/compiled_scene.h"

namespace plan {

/// By light of the scene: whether something can receive its light. After geometry and media. Careful: a light counts
/// as received unless it is sure that it is not.
std::vector<bool> received_lights(const CompiledScene& scene, const PhotonPlan* photons);

}  // namespace plan
