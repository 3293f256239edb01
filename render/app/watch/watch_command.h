#pragma once

#include "render/app/run/cancellation.h"

#include <string>
#include <vector>

namespace app {

/// `whittle watch`. Runs until a signal ends it. Returns the exit status.
int watch_command(const std::vector<std::string>& arguments, Cancellation& cancel);
std::string watch_help();  ///< what --help prints

}  // namespace app
