#pragma once

#include "render/app/run/cancellation.h"

#include <string>
#include <vector>

namespace app {

/// `whittle mesh SCENE -o FILE`: objects as closed triangle meshes (docs/parts.md). Returns the exit status.
int mesh_command(const std::vector<std::string>& arguments, Cancellation& cancel);
std::string mesh_help();  ///< what --help prints

}  // namespace app
