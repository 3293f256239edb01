#pragma once

#include <string>
#include <vector>

namespace app {

/// `whittle open`. Returns the exit status.
int open_command(const std::vector<std::string>& arguments);
std::string open_help();  ///< what --help prints

}  // namespace app
