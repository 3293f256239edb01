#pragma once

#include "render/app/run/cancellation.h"

#include <string>
#include <vector>

namespace app {

std::string farm_help();

/// `whittle farm SCENE --for=ENGINE`: writes the folder that hands a job in. \return exit status
int farm_command(const std::vector<std::string>& arguments, Cancellation& cancel);

}  // namespace app
