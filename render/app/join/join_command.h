#pragma once

#include <string>
#include <vector>

namespace app {

/// What `whittle join` wants.
std::string join_help();

/// Makes one picture of its parts, or tells what is missing. Returns the exit status: kSuccess, kError where the parts
/// never become a picture, kTryAgain where tasks that are run once more may bring what is missing.
int join_command(const std::vector<std::string>& arguments);

}  // namespace app
