#pragma once

#include <string>

namespace model {

/// All of a file. Throws ModelError with what the system says.
std::string bytes_of_file(const std::string& path);

}  // namespace model
