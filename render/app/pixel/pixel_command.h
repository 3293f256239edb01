#pragma once

#include "render/app/run/cancellation.h"

#include <string>
#include <vector>

namespace app {

/// `whittle pixel`. Returns the exit status.
int pixel_command(const std::vector<std::string>& arguments, Cancellation& cancel);
std::string pixel_help();  ///< what --help prints

}  // namespace app
