#pragma once

#include <string>

namespace app {

/// --help: usage, Whittle's options, and every POV-Ray option with what becomes of it.
std::string help_text();

/// --version.
std::string version_text();

}  // namespace app
