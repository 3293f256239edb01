#pragma once

#include <optional>
#include <string>

namespace image {

/// What FileSettings::fingerprint said when the file was written; nothing where the file has none, is of another type
/// or cannot be read. Looks at the entries before the pixels alone.
std::optional<std::string> fingerprint_in(const std::string& path);

}  // namespace image
