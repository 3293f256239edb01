#include "language/format/spacing.h"

namespace language::format {
namespace {

using parser::Kind;

bool word_char(char c)
{
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// Side by side the two would be read as something else.
bool would_join(const Piece& a, const Piece& b, std::string_view text)
{
    if (a.what != PieceKind::Token) return false;
    const char last = text[a.end - 1], first = text[b.begin];
    if (a.kind == Kind::Number && (word_char(first) || first == '.')) return true;
    if (a.kind == Kind::Number && (last == 'e' || last == 'E') && (first == '+' || first == '-')) return true;
    if (word_char(last) && word_char(first)) return true;
    if (last == '.' && (word_char(first) || first == '.') && !(first > '9')) return true;
    if (first == '=' && (last == '<' || last == '>' || last == '!')) return true;
    return last == '/' && (first == '/' || first == '*');
}

bool opens(const Piece& p)
{
    return p.kind == Kind::LeftParen || p.kind == Kind::LeftSquare || p.role == Role::OpensVector;
}

bool closes(const Piece& p)
{
    return p.kind == Kind::RightParen || p.kind == Kind::RightSquare || p.role == Role::ClosesVector;
}

/// `sin (x)` is a call, `scale (2)` is not.
bool called(const Piece& p)
{
    switch (p.kind) {
    case Kind::Identifier:
    case Kind::Function: return true;
    case Kind::X:
    case Kind::Y:
    case Kind::Z:
    case Kind::Pi:
    case Kind::Tau:
    case Kind::Clock:
    case Kind::On:
    case Kind::Off:
    case Kind::Yes:
    case Kind::No:
    case Kind::True:
    case Kind::False:
    case Kind::Version: return false;
    default: break;
    }
    const parser::LexicalClass way = parser::lexical_class(p.kind);
    return way == parser::LexicalClass::Float || way == parser::LexicalClass::Vector ||
           way == parser::LexicalClass::String;
}

bool odd_mark(Kind kind)
{
    return kind == Kind::At || kind == Kind::Percent || kind == Kind::Caret || kind == Kind::Dollar ||
           kind == Kind::Tilde || kind == Kind::Apostrophe || kind == Kind::Backquote || kind == Kind::Backslash;
}

bool wanted(const Piece& a, const Piece& b)
{
    if (a.what != PieceKind::Token || b.what != PieceKind::Token) return b.blank_before;
    if (odd_mark(a.kind) || odd_mark(b.kind)) return b.blank_before;
    if (a.kind == Kind::Hash || a.kind == Kind::Period || b.kind == Kind::Period) return false;
    if (b.kind == Kind::Comma || b.kind == Kind::Semicolon) return false;
    if (a.kind == Kind::Comma || a.kind == Kind::Semicolon) return true;
    if (opens(a) || closes(b)) return false;
    if (a.kind == Kind::LeftBrace && b.kind == Kind::RightBrace) return false;
    if (a.kind == Kind::LeftBrace || b.kind == Kind::LeftBrace || b.kind == Kind::RightBrace) return true;
    if (a.role == Role::Sign || a.role == Role::AsWritten || a.kind == Kind::Exclamation) return false;
    if (a.role == Role::Tight || b.role == Role::Tight) return false;
    if (b.kind == Kind::LeftParen) {
        if (a.kind == Kind::RightParen || a.kind == Kind::RightSquare) return b.blank_before;
        return !called(a);
    }
    return !(b.kind == Kind::LeftSquare && b.role == Role::Index);
}

}  // namespace

bool blank_before(const std::vector<Piece>& pieces, std::size_t at, std::string_view text)
{
    const Piece &a = pieces[at - 1], &b = pieces[at];
    if (b.what == PieceKind::LineComment) return true;
    return wanted(a, b) || would_join(a, b, text);
}

}  // namespace language::format
