#pragma once

#include "render/app/options/settings.h"

#include <string>

namespace app {

/// Writes what --json asks for. \return 0, or the system's number for why the file does not take it, which is told on
/// standard error.
/// \param path "-": standard output
int write_journal(const std::string& path, const std::string& text);

/// --json and --progress of a run that options ended before it began. Does nothing if they were not among those read
/// till then.
void journal_option_error(const Settings& settings, const std::string& text, int status);

}  // namespace app
