#pragma once

#include "render/scene/description.h"

#include <vector>

namespace scene {

/// What the scene asks for and the renderer does not do yet, each kind once, at the place of its first use.
std::vector<Unsupported> unsupported_features(const Description& description);

}  // namespace scene
