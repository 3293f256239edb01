#pragma once

#include "render/app/options/settings.h"

#include <optional>
#include <string>

namespace app {

/// The file that an input name means, as POV-Ray finds it (spec 1, 10.1): with .pov or .POV added unless it ends so, in
/// the current folder, then in those of `library_path`. The name itself if there is no such file.
std::string find_scene(const Settings& settings);

/// Nothing where it cannot be read.
std::optional<std::string> text_on_disk(const std::string& path);

}  // namespace app
