#pragma once

#include "language/format/format.h"
#include "language/format/pieces.h"

namespace language::format {

/// Pieces that stand on one line.
struct Line {
    std::size_t begin = 0, end = 0;  ///< pieces
    int level = 0;                   ///< of indentation
    std::uint32_t blank_lines = 0;   ///< before it
    bool as_written = false;         ///< between the comments `format off` and `format on`
};

/// The author's lines.
std::vector<Line> lines_of(const std::vector<Piece>& pieces, std::string_view text);

/// Gives each line its level: braces and directives that are open, and one for a line that goes on.
void indent(std::vector<Line>& lines, const std::vector<Piece>& pieces);

/// Columns that the pieces take, a comment at the end of the line excepted.
std::size_t width_of(const Line& line, const std::vector<Piece>& pieces, std::string_view text, const Options& options);

/// Breaks lines that are too long, once each. False: there is none that can be broken.
bool break_long(std::vector<Line>& lines, const std::vector<Piece>& pieces, std::string_view text,
                const Options& options);

/// Columns of a text in a fixed font: a UTF-8 character is one.
std::size_t columns(std::string_view text);

}  // namespace language::format
