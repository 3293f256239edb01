#include "language/places/hover.h"

#include "language/places/place_words.h"

#include <filesystem>

namespace language {

using parser::Kind;

namespace {

constexpr std::size_t kMostLines = 8, kMostBytes = 600;

/// The first lines of a statement, the rest as "...".
std::string shortened(std::string_view text)
{
    std::size_t end = 0, lines = 0;
    for (; end < text.size() && end < kMostBytes; ++end)
        if (text[end] == '\n' && ++lines == kMostLines) break;
    while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;
    return std::string(text.substr(0, end)) + (end < text.size() ? "\n..." : "");
}

/// A macro is told by its head, other names by what was given to them.
std::string code_of(const Found& found)
{
    const Document& document = found.known->document;
    const Declaration& one = found.declaration;
    if (one.by == DeclaredBy::Macro || one.by == DeclaredBy::Parameter) {
        std::size_t end = one.begin;
        while (end < one.end && document.kind(end) != Kind::LeftParen) ++end;
        const std::size_t close = document.partner(end);
        return shortened(document.text_of(one.begin, close == kNone ? end : close + 1));
    }
    return shortened(document.text_of(one.begin, one.end));
}

}  // namespace

std::optional<Hover> hover_at(Files& files, const std::string& path, std::uint32_t offset, const ValueOf& value_of)
{
    const KnownPtr known = files.find(path);
    if (!known) return {};
    const std::size_t token = known->document.word_at(offset);
    if (token == kNone || known->document.is_member(token)) return {};
    Hover hover;
    hover.word = known->document.range(token);
    if (known->document.kind(token) != Kind::Identifier) {
        hover.sentence = keyword_line(known->document.kind(token));
        if (hover.sentence.empty()) return {};
        return hover;
    }
    const Symbol symbol = symbol_of(*known, token);
    if (symbol.reach != Symbol::Reach::Scope) hover.value = value_of(symbol.word);
    const std::optional<Found> found = declaration_of(files, symbol, hover.word.begin);
    if (!found) {
        if (hover.value.empty()) return {};
        hover.where = "by the program";
        return hover;
    }
    hover.code = code_of(*found);
    const At at = found->at();
    hover.where = "line " + std::to_string(found->known->document.lines().place(at.range.begin).line);
    if (at.path != path) hover.where += " of " + std::filesystem::path(at.path).filename().string();
    return hover;
}

}  // namespace language
