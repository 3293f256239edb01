#pragma once

#include "render/app/embed/carried.h"

#include <string>
#include <vector>

namespace app {

/// Puts files into a folder, which is made if it is missing. No name and no symbolic link leads out of it. Files that
/// are there with the same bytes are left; where others are there, nothing is written, unless they may be replaced.
/// Throws std::runtime_error.
void put_files(const std::vector<Carried::File>& files, const std::string& folder, bool replace);

}  // namespace app
