#pragma once

#include "language/format/format.h"

#include <cstdint>
#include <optional>

namespace language::format {

/// A part of a text and what takes its place.
struct Edit {
    std::uint32_t begin = 0, end = 0;  ///< bytes
    std::string text;
};

/// What formatted() changes, from the first line that differs to the last; nothing: it is laid out. Throws Refused.
std::optional<Edit> layout_edit(std::string_view text, const Options& options = {});

/// The same of the lines that hold the bytes alone: laid out as they are within the whole text.
std::optional<Edit> layout_edit(std::string_view text, std::uint32_t begin, std::uint32_t end,
                                const Options& options = {});

}  // namespace language::format
