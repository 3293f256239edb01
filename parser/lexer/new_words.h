#pragma once

#include "parser/lexer/lexer.h"

namespace parser {

/// For who looks at a text without reading it, as editors do: words that only POV-Ray 3.8 has become keywords among the
/// tokens, but for those that this text declares somewhere and for members, as in `D.prefix`. While a scene is read,
/// TokenStream::as_word() knows better.
void settle_new_words(SourceFile& file, const Names& names);

}  // namespace parser
