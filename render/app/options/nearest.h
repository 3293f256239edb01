#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace app {

/// "; did you mean '<before><name>'?" with the name nearest to the word, whatever the case; empty if none is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& names, std::string_view before = "");

/// The same for the keyword of an INI file, and for a long option with its two dashes.
std::string nearest_keyword(std::string_view word);
std::string nearest_own_option(std::string_view word);

}  // namespace app
