#pragma once

#include "language/format/pieces.h"

namespace language::format {

/// Whether a blank stands before pieces[at] when the piece before it is on the same line.
bool blank_before(const std::vector<Piece>& pieces, std::size_t at, std::string_view text);

}  // namespace language::format
