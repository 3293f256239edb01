#include "parser/lexer/lexer.h"

#include <algorithm>

namespace parser {

void SourceFile::give_text_back(std::function<std::string()> reread)
{
    lines();
    std::string().swap(text);  // an assignment would keep its memory
    reread_ = std::move(reread);
}

void SourceFile::do_without(std::string_view whole, std::function<std::string()> reread)
{
    lines_ = scene::LineTable(whole);
    reread_ = std::move(reread);
}

const std::string& SourceFile::whole_text() const
{
    if (!reread_) return text;
    if (again_.empty()) again_ = reread_();
    return again_;
}

const scene::LineTable& SourceFile::lines() const
{
    if (lines_.empty()) lines_ = scene::LineTable(text);
    return lines_;
}

std::string_view SourceFile::line_text(std::uint32_t line) const
{
    if (line == 0 || line > lines().lines()) return {};
    const std::string_view all = whole_text();
    const std::string_view rest = all.substr(std::min<std::size_t>(lines().start(line), all.size()));
    return rest.substr(0, rest.find_first_of("\r\n"));
}

namespace {

/// What a message quotes is the token that would stand there: '<' or a number.
std::string_view first_of_numbers(std::string_view rest)
{
    const std::size_t length = rest.find_first_not_of("0123456789.eE");
    return rest.substr(0, std::max<std::size_t>(length, 1));
}

}  // namespace

std::string_view SourceFile::token_text(const Token& token) const
{
    const std::string_view all = whole_text();
    const std::string_view rest = all.substr(std::min<std::size_t>(token.offset, all.size()));
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
    case Kind::Numbers: return first_of_numbers(rest);
    default:
        if (token.kind == Kind::Identifier || token.kind == Kind::Faces || is_keyword(token.kind))
            return until([&](std::size_t i) { return !word_char(i); });
        return rest.substr(0, spelling(token.kind).size());
    }
}

}  // namespace parser
