#include "parser/stream/token_stream.h"

#include "parser/lexer/color_word.h"

#include <fmt/format.h>

#include <algorithm>

/// What an author who wrote the text ahead most likely meant. Asked only when an error is told.
namespace parser {
namespace {

/// Numbers that a keyword takes as a vector; 0: it takes none.
std::size_t components_of(Kind keyword)
{
    switch (keyword) {
    case Kind::Translate:
    case Kind::Rotate:
    case Kind::Scale:
    case Kind::Location:
    case Kind::LookAt:
    case Kind::Direction:
    case Kind::Right:
    case Kind::Up:
    case Kind::Sky: return 3;
    default: return static_cast<std::size_t>(color_word(keyword).components);
    }
}

bool is_axis(Kind kind) { return kind == Kind::X || kind == Kind::Y || kind == Kind::Z; }

}  // namespace

std::string TokenStream::hint_at(const Token& found) const
{
    const SourceFile& source = *files_[found.file];
    const std::vector<Token>& tokens = source.tokens;
    const auto before = [](const Token& a, std::uint32_t offset) { return a.offset < offset; };
    const auto at =
        static_cast<std::size_t>(std::lower_bound(tokens.begin(), tokens.end(), found.offset, before) - tokens.begin());
    if (at == 0 || at >= tokens.size()) return {};

    if (is_axis(found.kind) && tokens[at - 1].kind == Kind::Number)
        return fmt::format("; did you mean '{}*{}'?", source.token_text(tokens[at - 1]), source.token_text(found));

    // `rgb 1 1 0`, with commas too: the numbers around this place, from the keyword on.
    const auto listed = [&](std::size_t i) {
        const Kind kind = tokens[i].kind;
        return kind == Kind::Number || kind == Kind::Comma || kind == Kind::Minus;
    };
    std::size_t first = at;
    while (first > 0 && listed(first - 1)) --first;
    const std::size_t wanted = first > 0 ? components_of(tokens[first - 1].kind) : 0;
    if (wanted == 0 || first == at) return {};
    std::string vector;
    std::size_t count = 0;
    for (std::size_t i = first; i < tokens.size() && listed(i) && count < wanted; ++i) {
        const Kind kind = tokens[i].kind;
        if (kind == Kind::Comma) continue;
        if (kind == Kind::Minus && (i + 1 >= tokens.size() || tokens[i + 1].kind != Kind::Number)) return {};
        const bool negative = i > first && tokens[i - 1].kind == Kind::Minus;
        if (kind != Kind::Number) continue;
        vector += fmt::format("{}{}{}", count == 0 ? "" : ", ", negative ? "-" : "", source.token_text(tokens[i]));
        ++count;
    }
    if (count != wanted) return {};
    return fmt::format("; did you mean '{} <{}>'?", source.token_text(tokens[first - 1]), vector);
}

}  // namespace parser
