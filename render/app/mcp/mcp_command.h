#pragma once

#include <string>
#include <vector>

namespace app {

/// `whittle mcp`. Returns the exit status.
int mcp_command(const std::vector<std::string>& arguments);
std::string mcp_help();  ///< what --help prints

}  // namespace app
