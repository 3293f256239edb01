#pragma once

#include "render/scene/description.h"

#include <vector>

namespace scene {

/// What the scene asks for and the renderer does not do yet, each kind once, at the place of its first use. What is
/// declared and stands in no object of the scene asks for nothing. `in_objects`: whether objects, with textures,
/// interiors and lights, can hold anything of the kind.
std::vector<Unsupported> unsupported_features(const Description& description, bool in_objects);

}  // namespace scene
