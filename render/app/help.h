#pragma once

#include <string>

namespace app {

/// --help: usage, Whittle's options, and every POV-Ray option with what becomes of it.
std::string help_text();

/// --version.
std::string version_text();

/// The same under the name povray: callers look for "POV-Ray" and "official" in one line.
std::string povray_version_text();

}  // namespace app
