#pragma once

#include <string>
#include <vector>

namespace app {

/// Where standard include files are looked for after the folders of +L: the folders of the environment variable
/// WHITTLE_LIBRARY_PATH (separated by ':') if it is set, else `share/povray-3.7` or
/// `share/povray` below the program's own prefix (a portable archive brings it), else those of an installed
/// povray-includes package.
std::vector<std::string> default_library_path();

}  // namespace app
