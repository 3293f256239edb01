#include "language/format/pieces.h"

#include <algorithm>

// What '<', '[', '-' mean where they stand. The grammar would know for sure, but only of text that is run; a wrong
// guess here costs a blank and nothing else.
namespace language::format {
namespace {

using parser::Kind;

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

std::size_t token_before(const std::vector<Piece>& pieces, std::size_t at)
{
    while (at-- > 0)
        if (pieces[at].what == PieceKind::Token) return at;
    return kNone;
}

/// Words that are values by themselves.
bool value_word(Kind kind)
{
    switch (kind) {
    case Kind::X:
    case Kind::Y:
    case Kind::Z:
    case Kind::U:
    case Kind::V:
    case Kind::T:
    case Kind::Pi:
    case Kind::Tau:
    case Kind::Clock:
    case Kind::True:
    case Kind::False:
    case Kind::Yes:
    case Kind::No:
    case Kind::On:
    case Kind::Off: return true;
    default: return false;
    }
}

/// Behind an operand '<' compares, unless a list with commas follows up to a '>'.
bool list_follows(const std::vector<Piece>& pieces, std::size_t at)
{
    constexpr std::size_t kFurthest = 200;
    int depth = 0;
    bool comma = false;
    for (std::size_t i = at + 1; i < pieces.size() && i < at + kFurthest; ++i) {
        if (pieces[i].what != PieceKind::Token) continue;
        switch (pieces[i].kind) {
        case Kind::LeftParen:
        case Kind::LeftSquare: ++depth; break;
        case Kind::RightParen:
        case Kind::RightSquare:
            if (--depth < 0) return false;
            break;
        case Kind::Comma: comma = comma || depth == 0; break;
        case Kind::Greater:
            if (depth == 0) return comma;
            break;
        case Kind::Semicolon:
        case Kind::LeftBrace:
        case Kind::RightBrace:
        case Kind::Hash:
        case Kind::Question: return false;
        case Kind::Ampersand:
        case Kind::Bar:
            if (depth == 0) return false;
            break;
        default: break;
        }
    }
    return false;
}

/// What has a blank before it, or none, whatever was written: the operator's own blanks cannot be seen there.
bool decides_by_itself(const Piece& piece)
{
    if (piece.what == PieceKind::LineComment) return true;
    switch (piece.kind) {
    case Kind::LeftBrace:
    case Kind::RightBrace:
    case Kind::RightParen:
    case Kind::RightSquare:
    case Kind::Greater:
    case Kind::Comma:
    case Kind::Semicolon:
    case Kind::Period: return true;
    default: return false;
    }
}

Role operator_role(const std::vector<Piece>& pieces, std::size_t at)
{
    const bool before = pieces[at].blank_before;
    const bool after = at + 1 < pieces.size() && (pieces[at + 1].blank_before || decides_by_itself(pieces[at + 1]));
    const bool sum = pieces[at].kind == Kind::Plus || pieces[at].kind == Kind::Minus;
    if (sum && before && !after) return Role::AsWritten;
    return before || after ? Role::Spaced : Role::Tight;
}

}  // namespace

bool ends_operand(const std::vector<Piece>& pieces, std::size_t at)
{
    const Piece& piece = pieces[at];
    switch (piece.kind) {
    case Kind::Identifier:
    case Kind::Number:
    case Kind::String:
    case Kind::RightParen:
    case Kind::RightSquare: return true;
    case Kind::Greater: return piece.role == Role::ClosesVector;
    default: break;
    }
    if (value_word(piece.kind)) return true;
    const std::size_t before = parser::is_keyword(piece.kind) ? token_before(pieces, at) : kNone;
    return before != kNone && pieces[before].kind == Kind::Period;  // C.red
}

void find_roles(std::vector<Piece>& pieces)
{
    std::vector<std::size_t> open;  // brackets
    const auto drop_vectors = [&] {
        while (!open.empty() && pieces[open.back()].role == Role::OpensVector) {
            pieces[open.back()].role = Role::Plain;
            open.pop_back();
        }
    };
    const auto close = [&](Kind opening) {
        drop_vectors();
        if (open.empty() || pieces[open.back()].kind != opening) return Role::Plain;
        const Role role = pieces[open.back()].role;
        open.pop_back();
        return role;
    };
    for (std::size_t at = 0; at < pieces.size(); ++at) {
        Piece& piece = pieces[at];
        if (piece.what != PieceKind::Token) continue;
        const std::size_t before = token_before(pieces, at);
        const bool operand = before != kNone && ends_operand(pieces, before);
        switch (piece.kind) {
        case Kind::Less:
            if (operand && !list_follows(pieces, at)) break;
            piece.role = Role::OpensVector;
            open.push_back(at);
            break;
        case Kind::Greater:
            if (open.empty() || pieces[open.back()].role != Role::OpensVector) break;
            piece.role = Role::ClosesVector;
            open.pop_back();
            break;
        case Kind::LeftParen: open.push_back(at); break;
        case Kind::LeftSquare:
            if (before != kNone && (pieces[before].kind == Kind::Identifier || pieces[before].kind == Kind::Array ||
                                    (pieces[before].kind == Kind::RightSquare && pieces[before].role == Role::Index)))
                piece.role = Role::Index;
            open.push_back(at);
            break;
        case Kind::RightParen: close(Kind::LeftParen); break;
        case Kind::RightSquare: piece.role = close(Kind::LeftSquare); break;
        case Kind::LeftBrace:
        case Kind::RightBrace:
        case Kind::Semicolon:
        case Kind::Hash: drop_vectors(); break;
        case Kind::Plus:
        case Kind::Minus:
        case Kind::Star:
        case Kind::Slash: piece.role = operand ? operator_role(pieces, at) : Role::Sign; break;
        default: break;
        }
    }
    drop_vectors();
}

}  // namespace language::format
