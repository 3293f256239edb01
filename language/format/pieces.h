#pragma once

#include "parser/lexer/token.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace language::format {

enum class PieceKind : std::uint8_t { Token, LineComment, BlockComment };

/// What a mark means where it stands.
enum class Role : std::uint8_t {
    Plain,
    OpensVector,   ///< '<'
    ClosesVector,  ///< '>'
    Index,         ///< '[' or ']' of an array's element
    Sign,          ///< '-' or '+' of one operand
    Tight,         ///< operator without blanks about it
    Spaced,        ///< operator with them
    AsWritten      ///< `1 -2`: two values or a difference, only the reader's place tells
};

/// A token or a comment of a text.
struct Piece {
    PieceKind what = PieceKind::Token;
    parser::Kind kind = parser::Kind::EndOfText;  ///< of a token
    Role role = Role::Plain;
    bool blank_before = false;         ///< blanks or a line end stand before it in the text
    std::uint32_t begin = 0, end = 0;  ///< bytes of the text; a line comment ends before its trailing blanks
    std::uint32_t lines_before = 0;    ///< line ends between the piece before and this one
};

/// Tokens and comments of a text in order. Throws Refused.
std::vector<Piece> pieces_of(std::string_view text);

/// Gives operators and brackets their roles.
void find_roles(std::vector<Piece>& pieces);

/// Bytes above 127 at the start of a text, which the lexer passes over.
std::uint32_t skipped_start(std::string_view text);

bool ends_operand(const std::vector<Piece>& pieces, std::size_t at);  ///< a value may end with this piece

}  // namespace language::format
