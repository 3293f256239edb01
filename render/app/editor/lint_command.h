#pragma once

#include <string>
#include <vector>

namespace app {

inline constexpr int kNothingFound = 0, kFound = 1, kUnreadable = 2;

/// `whittle lint SCENE`: doubts about a scene (render/lint). Returns one of these.
int lint_command(const std::vector<std::string>& arguments);
std::string lint_help();  ///< what --help prints

}  // namespace app
