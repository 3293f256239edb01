#pragma once

#include "render/app/run/cancellation.h"

#include <string>
#include <vector>

namespace app {

/// `whittle info SCENE`: extent, volume, surface, centre and inertia of each object
/// (docs/parts.md). Returns the exit status.
int info_command(const std::vector<std::string>& arguments, Cancellation& cancel);
std::string info_help();  ///< what --help prints

}  // namespace app
