#include "parser/lexer/lexer.h"

#include <algorithm>

namespace parser {

const std::vector<std::uint32_t>& SourceFile::line_starts() const
{
    if (!line_starts_.empty()) return line_starts_;
    line_starts_.push_back(0);
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (c != '\n' && c != '\r') continue;
        // CR LF and LF CR are one line end.
        if (at + 1 < text.size() && text[at + 1] == (c == '\n' ? '\r' : '\n')) ++at;
        line_starts_.push_back(static_cast<std::uint32_t>(at + 1));
    }
    return line_starts_;
}

SourceFile::Place SourceFile::locate(std::uint32_t offset) const
{
    const auto& starts = line_starts();
    const auto line = std::upper_bound(starts.begin(), starts.end(), offset) - starts.begin();
    return {static_cast<std::uint32_t>(line), offset - starts[static_cast<std::size_t>(line - 1)] + 1};
}

std::string_view SourceFile::line_text(std::uint32_t line) const
{
    const auto& starts = line_starts();
    if (line == 0 || line > starts.size()) return {};
    const std::string_view rest = std::string_view(text).substr(starts[line - 1]);
    return rest.substr(0, rest.find_first_of("\r\n"));
}

std::string_view SourceFile::token_text(const Token& token) const
{
    const std::string_view rest = std::string_view(text).substr(std::min<std::size_t>(token.offset, text.size()));
    const auto until = [&](auto stop) {
        std::size_t length = 1;
        while (length < rest.size() && !stop(length)) ++length;
        return rest.substr(0, length);
    };
    const auto word_char = [&](std::size_t i) {
        const char c = rest[i];
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    };
    switch (token.kind) {
    case Kind::EndOfText: return {};
    case Kind::Number:
        return until([&](std::size_t i) {
            const bool exponent = rest[i - 1] == 'e' || rest[i - 1] == 'E';
            return !((rest[i] >= '0' && rest[i] <= '9') || rest[i] == '.' || rest[i] == 'e' || rest[i] == 'E' ||
                     (exponent && (rest[i] == '+' || rest[i] == '-')));
        });
    case Kind::String: {
        const auto body = until([&](std::size_t i) { return rest[i] == '"' && rest[i - 1] != '\\'; });
        return rest.substr(0, std::min(rest.size(), body.size() + 1));
    }
    case Kind::Bad: return rest.substr(0, 1);
    default:
        if (token.kind == Kind::Identifier || is_keyword(token.kind))
            return until([&](std::size_t i) { return !word_char(i); });
        return rest.substr(0, spelling(token.kind).size());
    }
}

}  // namespace parser
