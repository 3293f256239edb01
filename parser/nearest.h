#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace parser {

/// The name nearest to `word`, upper and lower case being one; empty if none is near enough to be a slip of the pen.
std::string nearest_of(std::string_view word, const std::vector<std::string>& names);

}  // namespace parser
