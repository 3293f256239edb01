#pragma once

#include <string>
#include <vector>

namespace app {

/// `whittle lint SCENE`: doubts about a scene (render/lint). Returns an exit status.
int lint_command(const std::vector<std::string>& arguments);
std::string lint_help();  ///< what --help prints

}  // namespace app
