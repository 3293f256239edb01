#pragma once

#include <string>
#include <string_view>

namespace app {

/// The file has these bytes or, if anything fails, those that it had. Links are followed, permissions kept.
/// Throws std::runtime_error.
void replace_file(const std::string& path, std::string_view bytes);

/// All bytes of a file, of standard input where it is "-". Throws std::runtime_error.
std::string whole_file(const std::string& path);

}  // namespace app
