#pragma once

#include "render/app/options/settings.h"

namespace app {

/// What --benchmark renders: POV-Ray's benchmark scene with its own INI file, where the distribution's scenes are
/// installed beside the include files. No picture is written. Throws OptionError if there is no such scene.
void apply_benchmark(Settings& settings);

}  // namespace app
