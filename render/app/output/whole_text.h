#pragma once

#include <string>

/// Files that are written at once, when all that is in them is known.
namespace app {

/// Throws OptionError unless a file can be written there: to be asked before an hour of work.
void check_place(const std::string& path);

/// The file has these bytes, or is what it was. Throws image::FileError.
void put_bytes(const std::string& path, const std::string& bytes);

}  // namespace app
