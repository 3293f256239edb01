#pragma once

#include "render/app/options/settings.h"
#include "render/app/run/cancellation.h"

#include <string>

namespace app {

/// Everything from the scene file to the picture file, frame by frame. Returns the exit status.
/// \param cancel when requested the trace stops and nothing is written
/// \param remains gets what the last frame was made from
int render_command(const Settings& settings, Cancellation& cancel, Remains& remains);

}  // namespace app
