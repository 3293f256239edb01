#pragma once

#include "render/app/run/cancellation.h"

#include <string>
#include <vector>

namespace app {

std::string plan_help();

/// `whittle plan SCENE [options]`: what a job costs in how many tasks. \return exit status
int plan_command(const std::vector<std::string>& arguments, Cancellation& cancel);

}  // namespace app
