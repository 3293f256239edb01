#pragma once

#include "render/app/options/settings.h"

#include <string>
#include <vector>

namespace app {

/// The options of a run that its picture depends on, as lines of an INI file: none that name files, folders, commands
/// or logs, which collect.h adds with names of its own.
/// \param frame  of an animation: it alone is asked for; null: a single picture
std::vector<std::string> picture_options(const Settings& settings, const int* frame);

/// One line for a file or a folder.
/// \param folder  that the options lie in
std::string file_option(const char* keyword, const std::string& name, const std::string& folder);

/// Whether a picture may bring a line: one of those that are written here, and where it names a file, one that stays in
/// what is taken out. Whoever made the picture may have written others into it.
bool may_bring(const std::string& line, const std::string& folder);

}  // namespace app
