#pragma once

#include "parser/lexer/lexer.h"
#include "render/scene/base/message.h"

#include <string>
#include <string_view>

namespace parser {

/// The line of a place, which is somewhere. Long lines are cut around it.
scene::QuotedLine quoted_line(const SourceFile& file, const scene::LineAndColumn& at);

/// The text with '?' for control characters and for bytes that are no UTF-8; tabs stay.
std::string printable(std::string_view text);
/// The last beginning of a UTF-8 character at or before byte `at`.
std::size_t character_start(std::string_view text, std::size_t at);

}  // namespace parser
