#pragma once

#include "render/app/frames/frames.h"
#include "render/app/options/settings.h"

#include <string>

namespace app {

/// Where the picture goes: "" for standard output or error, else a path (spec 1, 19.1). The scene `sub/d.pov` without
/// +O gives `sub/d.png`, as in POV-Ray; a scene named on its own gives a picture in the current folder.
std::string output_path(const Settings& settings, const FrameList& list, const Frame& frame);

/// What --prepare leaves for the parts of a picture, beside it.
/// \param path  of output_path()
std::string prepared_path(const Settings& settings, const std::string& path);

/// +O- or +Ostdout.
bool to_standard_output(const Settings& settings);

/// +Ostderr: the picture among the text, as POV-Ray has it.
bool to_standard_error(const Settings& settings);

}  // namespace app
