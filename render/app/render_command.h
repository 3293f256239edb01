#pragma once

#include "render/app/settings.h"

#include <atomic>

namespace app {

inline constexpr int kSuccess = 0, kError = 1, kCancelled = 2;  // POV-Ray's exit codes

/// Everything from the scene file to the picture file, frame by frame. Returns the exit status.
/// \param cancel set by a signal: the trace stops and nothing is written
int render_command(Settings& settings, const std::atomic<bool>& cancel);

}  // namespace app
