#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace image {

inline constexpr std::size_t kMostCarried = std::size_t{80} << 20;  ///< bytes that a picture may carry, packed

/// What FileSettings::carried said when the file was written; nothing where the file carries nothing. Looks at the
/// entries before and behind the pixels, never at these. Throws FileError for a file that cannot be read, is of a type
/// that carries nothing, is cut off before it is found, or holds a damaged one.
std::optional<std::string> carried_in(const std::string& path);

}  // namespace image
