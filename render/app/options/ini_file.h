#pragma once

#include "render/app/options/settings.h"

#include <string>

namespace app {

/// Applies an INI file, `name` or `name[section]`, with or without its extension, from the current folder or the
/// library path (spec 1, 18.2 and 18.4). False if there is no such file. Throws OptionError with file and line.
bool read_ini_file(Settings& settings, const std::string& name);

/// The INI file that applies without being named, the first that exists: of the environment variable POVINI,
/// ./povray.ini,
/// ~/.povray/3.7/povray.ini, /etc/povray/3.7/povray.ini, ~/.povrayrc. With one that names no size it is 160x120.
void read_default_ini_file(Settings& settings);

/// The lines of an INI file.
/// \param section  only its lines and those before the first section apply
void apply_ini_text(Settings& settings, const std::string& text, const std::string& section,
                    const std::string& file_name);

}  // namespace app
