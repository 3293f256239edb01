#pragma once

#include "render/app/run/cancellation.h"

#include <string>
#include <vector>

namespace app {

/// `whittle report SCENE...`: error against run time as a page, CSV and JSON (docs/error_and_time.md). Returns the exit
/// status; a scene that cannot be measured stands in the report with its reason, and the status is that of an error.
int report_command(const std::vector<std::string>& arguments, Cancellation& cancel);
std::string report_help();  ///< what --help prints

}  // namespace app
