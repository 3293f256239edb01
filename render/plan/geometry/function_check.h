#pragma once

#include "render/scene/description.h"

#include <string>
#include <vector>

namespace plan {

/// Functions of isosurfaces and parametric surfaces that give no number at some places of what contains them, a
/// sentence each: nothing is drawn there, and nobody would know why. Few places are asked; functions that ask the scene
/// are left alone.
std::vector<std::string> functions_without_number(const scene::Description& description);

}  // namespace plan
