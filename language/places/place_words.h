#pragma once

#include "parser/lexer/token.h"

#include <string>
#include <string_view>
#include <vector>

namespace language {

/// Words that may follow '#'.
const std::vector<std::string>& directive_words();
/// Words that begin a statement outside of all blocks.
const std::vector<std::string>& scene_words();
/// Words that may begin a number, a vector or a text.
const std::vector<std::string>& number_words();
/// Words that may begin what a name is given: all of those, colours, objects, textures.
const std::vector<std::string>& value_words();
/// Words that may stand in the block of a keyword, in a block of `outer` (EndOfText: in none); empty: nothing is known.
std::vector<std::string> block_words(parser::Kind block, parser::Kind outer);
/// Words that may stand right behind a keyword of such a block, as `albedo` does behind `diffuse`.
std::vector<std::string> words_behind(parser::Kind keyword, parser::Kind block, parser::Kind outer);

/// What a keyword does, in one line; empty: there is none.
std::string_view keyword_line(parser::Kind keyword);

}  // namespace language
