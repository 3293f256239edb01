#pragma once

#include "render/app/run/run.h"

namespace app {

/// One frame from the scene file to the picture file. Returns the exit status; throws for what ends the run.
int render_frame(Run& run, const Frame& frame);

}  // namespace app
