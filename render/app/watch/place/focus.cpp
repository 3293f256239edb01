#include "render/app/watch/place/focus.h"

#include <algorithm>

namespace app {
namespace {

using language::Document;
using language::kNone;
using parser::Kind;

/// From the word in front of a brace to what closes that; not closed: to the end.
language::Range statement_of(const Document& document, std::size_t brace)
{
    const std::size_t first = brace > 0 && document.is_word(brace - 1) ? brace - 1 : brace;
    const std::size_t last = document.partner(brace);
    const auto end = last != kNone ? document.range(last).end : static_cast<std::uint32_t>(document.text().size());
    return {document.range(first).begin, end};
}

/// Numbers that are a token each: long lists of them, as in a mesh, are one token and nobody turns those by hand.
FocusedNumber number_of(const Document& document, std::size_t token)
{
    FocusedNumber out{document.range(token), document.tokens()[token].number, {}};
    // With its sign, where that is no difference.
    const auto ends_value = [&](Kind k) {
        return k == Kind::Number || k == Kind::Identifier || k == Kind::RightParen || k == Kind::Greater;
    };
    if (token > 0 && document.kind(token - 1) == Kind::Minus && (token == 1 || !ends_value(document.kind(token - 2)))) {
        out.range.begin = document.range(token - 1).begin;
        out.value = -out.value;
    }
    for (std::size_t at = token; at-- > 0 && document.kind(at) != Kind::RightBrace;) {
        const bool begins_block = document.kind(at) == Kind::LeftBrace;
        if (begins_block && at > 0) --at;
        if (document.is_word(at)) out.word = document.word(at);
        if (document.is_word(at) || begins_block) break;
    }
    return out;
}

}  // namespace

Focus focus_at(const Document& document, std::uint32_t offset, std::size_t most)
{
    Focus out;
    offset = std::min(offset, static_cast<std::uint32_t>(document.text().size()));
    // On the word or the brace that begins a block, that block is meant.
    const std::size_t word = document.word_at(offset), near = word != kNone ? word + 1 : document.before(offset + 1);
    std::size_t brace = near != kNone && document.kind(near) == Kind::LeftBrace && document.range(near).begin >= offset
                            ? near
                            : document.open_brace(offset);
    const std::size_t innermost = brace;
    while (brace != kNone) {
        out.statements.push_back(statement_of(document, brace));
        brace = brace == 0 ? kNone : document.open_brace(document.range(brace).begin);
    }
    std::size_t first = 0, behind = document.tokens().size();
    if (innermost != kNone) {
        first = innermost;
        if (document.partner(innermost) != kNone) behind = document.partner(innermost);
    } else {  // outside of all blocks: the line
        const auto line = document.lines().place(offset).line;
        while (first < behind && document.lines().place(document.range(first).begin).line < line) ++first;
        for (std::size_t at = first; at < behind; ++at)
            if (document.lines().place(document.range(at).begin).line > line) behind = at;
    }
    for (std::size_t at = first; at < behind; ++at) {
        if (document.kind(at) != Kind::Number) continue;
        FocusedNumber number = number_of(document, at);
        const bool here = number.range.begin <= offset && offset <= number.range.end;
        if (here) out.numbers.insert(out.numbers.begin(), std::move(number));
        else if (out.numbers.size() < most) out.numbers.push_back(std::move(number));
    }
    if (out.numbers.size() > most) out.numbers.resize(most);
    return out;
}

FocusedNumber number_at(const Document& document, std::uint32_t offset)
{
    std::size_t at = document.before(offset + 1);
    if (at != kNone && document.kind(at) == Kind::Minus) ++at;
    if (at == kNone || document.kind(at) != Kind::Number) return {};
    FocusedNumber number = number_of(document, at);
    return number.range.begin == offset ? number : FocusedNumber{};
}

}  // namespace app
