#pragma once

#include "language/names/symbol.h"

#include <functional>
#include <optional>
#include <string>

namespace language {

/// What is told of a word.
struct Hover {
    Range word;
    std::string code;      ///< the declaration as written, shortened; empty for a keyword
    std::string value;     ///< what it came to when the scene was read; empty: not known
    std::string where;     ///< "line 3 of colors.inc"
    std::string sentence;  ///< of a keyword
};

/// The value of a global name in the scene that was read last; empty: none is known.
using ValueOf = std::function<std::string(const std::string& name)>;

/// What there is to tell of the word at a byte of a text; nothing: no word, or one without a meaning there.
std::optional<Hover> hover_at(Files& files, const std::string& path, std::uint32_t offset, const ValueOf& value_of);

}  // namespace language
