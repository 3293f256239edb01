#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace image {

/// Bytes in base64 with padding (RFC 4648, section 4).
std::string base64(std::string_view bytes);

/// Its bytes; nothing where a character or the padding is wrong.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace image
