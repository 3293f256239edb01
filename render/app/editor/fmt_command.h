#pragma once

#include <string>
#include <vector>

namespace app {

/// `whittle fmt FILE...`: lays scene text out again (language/format). Returns an exit status.
int fmt_command(const std::vector<std::string>& arguments);
std::string fmt_help();  ///< what --help prints

}  // namespace app
