#pragma once

#include "parser/base/reading.h"

#include <string>

namespace parser {

/// The file lies in the folder or below it, symbolic links resolved.
bool lies_below(const std::string& file, const std::string& folder);

/// A scene may write below the current folder and Options::write_folders.
bool may_write(const Options& options, const std::string& file);

/// Everything, unless Options::restrict_read: then what lies below the current folder, the scene's, those of the
/// library path and those where it may write.
bool may_read(const Options& options, const std::string& scene_folder, const std::string& file);

}  // namespace parser
