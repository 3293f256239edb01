#pragma once

#include "render/app/options/settings.h"

#include <string>

namespace app {

/// Writes what --json asks for. False, told on standard error, where the file does not take it.
/// \param path "-": standard output
bool write_journal(const std::string& path, const std::string& text);

/// --json of a run that options ended before it began. Does nothing if --json was not among those read till then.
void journal_option_error(const Settings& settings, const std::string& text);

}  // namespace app
