#pragma once

#include <string>
#include <vector>

namespace app {

std::string movie_help();

/// `whittle join --movie OUT FRAME...`. \return exit status
int movie_command(const std::vector<std::string>& arguments);

}  // namespace app
