#pragma once

#include "render/app/options/settings.h"

#include <string>

namespace app {

/// The options that were given, by the command line or INI files, as an INI file that gives them again: in the order of
/// the option table, each as given last.
std::string effective_ini(const Settings& settings);

/// One of its lines.
std::string ini_line(const struct Option& option, const std::string& text);

/// Writes it where Create_Ini says (a truth means the scene's name with .ini); does nothing without one. Throws
/// OptionError.
void write_effective_ini(const Settings& settings);

}  // namespace app
