#pragma once

#include <string>
#include <vector>

namespace app {

inline constexpr int kAgree = 0, kDiffer = 1, kNotCompared = 2;

/// `whittle compare A B [--out diff.png] [--tolerance n] [--share x]`. Returns the exit status: 0 if at least `share`
/// of the pixels are within n of 255 in every channel, 1 if not, 2 if the pictures cannot be compared.
int compare_command(const std::vector<std::string>& arguments);
std::string compare_help();  ///< what --help prints

}  // namespace app
