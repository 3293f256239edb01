#pragma once

#include "render/app/options/settings.h"

#include <string>
#include <vector>

namespace app {

/// Words of one argument: split at blanks outside quotes, quotes of either kind removed (spec 1, 18.2).
std::vector<std::string> words_of(const std::string& argument);

/// One word of a command line: a switch, Keyword=value, a scene, a library path ending in '/', or an INI file.
void apply_word(Settings& settings, const std::string& word);

/// The whole command line, left to right. Throws OptionError.
void apply_command_line(Settings& settings, const std::vector<std::string>& arguments);

}  // namespace app
