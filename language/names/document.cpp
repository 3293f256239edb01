#include "language/names/document.h"

#include "parser/lexer/new_words.h"

#include <algorithm>

namespace language {

using parser::Kind;
using parser::Token;

namespace {

Kind opening(Kind closing)
{
    switch (closing) {
    case Kind::RightBrace: return Kind::LeftBrace;
    case Kind::RightParen: return Kind::LeftParen;
    case Kind::RightSquare: return Kind::LeftSquare;
    default: return Kind::EndOfText;
    }
}

bool opens(Kind kind) { return kind == Kind::LeftBrace || kind == Kind::LeftParen || kind == Kind::LeftSquare; }

/// A closing bracket takes the nearest that it fits; what was opened in between stays alone.
std::vector<std::size_t> partners_of(const std::vector<Token>& tokens)
{
    std::vector<std::size_t> partners(tokens.size(), kNone), open;
    for (std::size_t at = 0; at < tokens.size(); ++at) {
        if (opens(tokens[at].kind)) open.push_back(at);
        const Kind wanted = opening(tokens[at].kind);
        if (wanted == Kind::EndOfText) continue;
        // A brace is never closed by what stands outside of it: a ')' looks no further than to the next '{'.
        std::size_t found = open.size();
        while (found > 0 && tokens[open[found - 1]].kind != wanted &&
               (wanted == Kind::LeftBrace || tokens[open[found - 1]].kind != Kind::LeftBrace))
            --found;
        if (found == 0 || tokens[open[found - 1]].kind != wanted) continue;
        partners[at] = open[found - 1];
        partners[open[found - 1]] = at;
        open.resize(found - 1);
    }
    return partners;
}

}  // namespace

Document::Document(std::string path, std::string text)
{
    file_.path = std::move(path);
    file_.text = std::move(text);
    parser::tokenize(file_, 0, names_, true);
    parser::settle_new_words(file_, names_);
    partners_ = partners_of(file_.tokens);
}

std::string_view Document::word(std::size_t at) const
{
    if (!is_word(at)) return {};
    return names_.word(tokens()[at].name);
}

bool Document::is_member(std::size_t at) const
{
    return at > 0 && kind(at) == Kind::Identifier && kind(at - 1) == Kind::Period;
}

Range Document::range(std::size_t at) const
{
    const Token& token = tokens()[at];
    const std::uint32_t begin = token.offset;
    if (token.kind == Kind::Numbers || token.kind == Kind::Faces)
        return {begin, at + 1 < tokens().size() ? tokens()[at + 1].offset : begin};
    return {begin, begin + static_cast<std::uint32_t>(file_.token_text(token).size())};
}

std::string_view Document::text_of(std::size_t first, std::size_t behind) const
{
    if (first >= behind || first >= tokens().size()) return {};
    const std::uint32_t begin = tokens()[first].offset, end = range(std::min(behind, tokens().size()) - 1).end;
    return std::string_view(text()).substr(begin, end - begin);
}

std::string_view Document::string(std::size_t at) const
{
    const auto [begin, end] = range(at);
    if (end - begin < 2) return {};
    return std::string_view(text()).substr(begin + 1, end - begin - 2);
}

std::size_t Document::before(std::uint32_t offset) const
{
    const auto found = std::lower_bound(tokens().begin(), tokens().end(), offset,
                                        [](const Token& token, std::uint32_t byte) { return token.offset < byte; });
    return found == tokens().begin() ? kNone : static_cast<std::size_t>(found - tokens().begin()) - 1;
}

std::size_t Document::word_at(std::uint32_t offset) const
{
    const std::size_t at = before(offset + 1);  // begins there or before
    for (const std::size_t one : {at, at == kNone || at == 0 ? kNone : at - 1})
        if (one != kNone && is_word(one) && range(one).end >= offset) return one;
    return kNone;
}

std::size_t Document::open_brace(std::uint32_t offset) const
{
    for (std::size_t at = before(offset); at != kNone; at = at == 0 ? kNone : at - 1) {
        if (kind(at) == Kind::LeftBrace) return at;
        if (kind(at) == Kind::RightBrace && partner(at) != kNone) at = partner(at);
    }
    return kNone;
}

std::vector<Range> comments_of(const Document& document)
{
    std::vector<Range> found;
    const std::string_view text = document.text();
    const auto size = static_cast<std::uint32_t>(text.size());
    std::size_t next = 0;
    for (std::uint32_t at = 0; at < size;) {
        // Tokens are passed over: a text may hold what looks like a comment. One that is no token ends nothing.
        while (next < document.tokens().size() && document.tokens()[next].offset < at) ++next;
        const bool token = next < document.tokens().size() && document.tokens()[next].offset == at;
        const bool bad = token && document.kind(next) == Kind::Bad;
        if (token && !(bad && text[at] == '/')) {
            const bool list = document.kind(next) == Kind::Numbers || document.kind(next) == Kind::Faces;
            at = list ? at + 1 : std::max(document.range(next).end, at + 1);
            continue;
        }
        if (text[at] != '/' || at + 1 == size || (text[at + 1] != '/' && text[at + 1] != '*')) {
            ++at;
            continue;
        }
        std::uint32_t end = at + 2;
        if (text[at + 1] == '/') {
            while (end < size && text[end] != '\n' && text[end] != '\r') ++end;
        } else {
            int depth = 1;
            for (; end < size && depth > 0; ++end) {
                if (end + 1 < size && text[end] == '/' && text[end + 1] == '*') ++depth, ++end;
                else if (end + 1 < size && text[end] == '*' && text[end + 1] == '/') --depth, ++end;
            }
        }
        found.push_back({at, std::min(end, size)});
        at = found.back().end;
    }
    return found;
}

}  // namespace language
