#include "parser/stream/files/data_file.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <stdexcept>

namespace parser {
namespace {

bool is(const std::string& text, std::size_t at, int (*test)(int))
{
    return at < text.size() && test(static_cast<unsigned char>(text[at])) != 0;
}

}  // namespace

bool DataFile::write(const std::string& bytes)
{
    if (!kept) return std::fwrite(bytes.data(), 1, bytes.size(), out.get()) == bytes.size();
    *kept += bytes;
    return true;
}

/// White space and both forms of comments, block comments within each other.
void DataFile::skip_blanks()
{
    for (;;) {
        if (is(text, position, std::isspace)) {
            ++position;
        } else if (text.compare(position, 2, "//") == 0) {
            position = std::min(text.find('\n', position), text.size());
        } else if (text.compare(position, 2, "/*") == 0) {
            std::size_t depth = 0;
            do {
                const bool opens = text.compare(position, 2, "/*") == 0, closes = text.compare(position, 2, "*/") == 0;
                depth += opens;
                depth -= closes;
                position += opens || closes ? 2 : 1;
            } while (depth > 0 && position < text.size());
        } else {
            return;
        }
    }
}

DataFile::Token DataFile::token()
{
    skip_blanks();
    if (position >= text.size()) return {};
    const char c = text[position];
    if (is(text, position, std::isdigit) || (c == '.' && is(text, position + 1, std::isdigit))) {
        Token number{Mark::Number, 0, {}};
        const auto [end, error] = std::from_chars(text.data() + position, text.data() + text.size(), number.number);
        if (error == std::errc::result_out_of_range) number.number = 0;
        position = static_cast<std::size_t>(end - text.data());
        return number;
    }
    if (c == '"') {
        Token string{Mark::Text, 0, {}};
        for (++position; position < text.size() && text[position] != '"'; ++position) {
            if (text[position] == '\\' && position + 1 < text.size() && text[position + 1] == '"') ++position;
            string.text += text[position];
        }
        position = std::min(position + 1, text.size());
        return string;
    }
    std::size_t end = position + 1;
    if (std::isalpha(static_cast<unsigned char>(c)) || c == '_')
        while (is(text, end, std::isalnum) || (end < text.size() && text[end] == '_')) ++end;
    Token other{Mark::Other, 0, text.substr(position, end - position)};
    position = end;
    return other;
}

double DataFile::signed_number(Token first)
{
    const bool negative = first.text == "-" && first.mark == Mark::Other;
    if (negative || (first.mark == Mark::Other && first.text == "+")) first = token();
    if (first.mark != Mark::Number)
        throw std::runtime_error("expected a number, found " +
                                 (first.mark == Mark::End ? "the end" : "'" + first.text + "'"));
    return negative ? -first.number : first.number;
}

std::optional<DataFile::Item> DataFile::read_item()
{
    Token first = token();
    if (first.mark == Mark::End) return std::nullopt;
    if (first.mark == Mark::Text) return std::move(first.text);
    if (first.mark != Mark::Other || first.text != "<") return signed_number(std::move(first));
    Vector vector;
    for (Token next = token(); next.mark != Mark::Other || next.text != ">"; next = token()) {
        if (vector.count == 5) throw std::runtime_error("expected '>' after five components");
        vector.at[static_cast<std::size_t>(vector.count++)] = signed_number(std::move(next));
        skip_blanks();
        if (position < text.size() && text[position] == ',') ++position;
    }
    if (vector.count < 2) throw std::runtime_error("a vector needs at least two components");
    return vector;
}

bool DataFile::skip_separator() { return token().mark != Mark::End; }

}  // namespace parser
