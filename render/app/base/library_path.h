#pragma once

#include <string>
#include <vector>

namespace app {

/// Where standard include files are looked for after the folders of +L: the folders of the environment variable
/// WHITTLE_LIBRARY_PATH (separated by ':') if it is set, else those of an installed povray-includes package.
std::vector<std::string> default_library_path();

}  // namespace app
