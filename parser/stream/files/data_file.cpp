#include "parser/stream/files/data_file.h"

#include "parser/lexer/short_number.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <stdexcept>
#include <system_error>

namespace parser {
namespace {

bool is(char c, int (*test)(int)) { return test(static_cast<unsigned char>(c)) != 0; }

/// As std::isspace has it.
bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

bool DataFile::write(const std::string& bytes)
{
    if (!kept) return std::fwrite(bytes.data(), 1, bytes.size(), out.get()) == bytes.size();
    *kept += bytes;
    return true;
}

/// More of the file stands in `text` then. False: there is no more.
bool DataFile::more()
{
    if (!in) return false;
    const std::size_t keep = std::min(position, held_ ? *held_ - dropped : position);
    text.erase(0, keep);
    position -= keep;
    dropped += keep;
    const std::size_t before = text.size();
    text.resize(before + window);
    const std::size_t got = std::fread(text.data() + before, 1, window, in.get());
    if (std::ferror(in.get()) != 0)
        throw std::system_error(errno, std::generic_category(), "cannot read '" + path + "'");
    text.resize(before + got);
    if (got < window) in.reset();
    return got > 0;
}

bool DataFile::fetch(std::size_t ahead)
{
    while (position + ahead >= text.size())
        if (!more()) return false;
    return true;
}

/// White space and both forms of comments, block comments within each other.
void DataFile::skip_blanks()
{
    while (has(0)) {
        if (is_blank(text[position])) {
            ++position;
        } else if (text[position] != '/') {
            return;
        } else if (stands("//")) {
            while (has(0) && text[position] != '\n') ++position;
        } else if (stands("/*")) {
            std::size_t depth = 0;
            do {
                const bool opens = stands("/*"), closes = stands("*/");
                depth += opens;
                depth -= closes;
                position += opens || closes ? 2 : 1;
            } while (depth > 0 && has(0));
        } else {
            return;
        }
    }
}

/// A number without a sign, if one begins here.
bool DataFile::plain_number(double& to)
{
    if (!has(0)) return false;
    const bool begins = is_digit(text[position]) || (text[position] == '.' && has(1) && is_digit(text[position + 1]));
    if (!begins) return false;
    if (text.size() - position > kShortNumber)
        if (const char* const end = short_number(text.data() + position, to)) {
            position = static_cast<std::size_t>(end - text.data());
            return true;
        }
    for (;;) {
        to = 0;
        const char* const last = text.data() + text.size();
        const auto [end, error] = std::from_chars(text.data() + position, last, to);
        constexpr std::ptrdiff_t kExponent = 2;  // `e+` and no digit yet
        if (in && last - end <= kExponent) {     // it may go on in what is not read yet
            more();
            continue;
        }
        if (error == std::errc::result_out_of_range) to = 0;
        position = static_cast<std::size_t>(end - text.data());
        return true;
    }
}

DataFile::Token DataFile::token()
{
    skip_blanks();
    if (!has(0)) return {};
    const char c = text[position];
    if (Token number{Mark::Number, 0, {}}; plain_number(number.number)) return number;
    if (c == '"') {
        Token string{Mark::Text, 0, {}};
        for (++position; has(0) && text[position] != '"'; ++position) {
            if (text[position] == '\\' && has(1) && text[position + 1] == '"') ++position;
            string.text += text[position];
        }
        position += has(0) ? 1 : 0;
        return string;
    }
    std::size_t length = 1;
    if (is(c, std::isalpha) || c == '_')
        while (has(length) && (is(text[position + length], std::isalnum) || text[position + length] == '_')) ++length;
    Token other{Mark::Other, 0, text.substr(position, length)};
    position += length;
    return other;
}

/// Short numbers with commas behind them, all in the text that was read already. False: nothing was taken.
bool DataFile::read_short_numbers(double* to, std::size_t count)
{
    if (text.size() <= position + kShortNumber) return false;
    const char* const limit = text.data() + text.size() - kShortNumber;
    const char* at = text.data() + position;
    const auto skip = [&] {
        while (at < limit && is_blank(*at)) ++at;
        return at < limit;
    };
    for (std::size_t i = 0; i < count; ++i) {
        if (!skip()) return false;
        const bool minus = *at == '-';
        at = short_number(at + (minus ? 1 : 0), to[i]);
        if (!at || !skip() || *at != ',') return false;
        to[i] = minus ? -to[i] : to[i];
        ++at;
    }
    position = static_cast<std::size_t>(at - text.data());
    return true;
}

bool DataFile::read_numbers(double* to, std::size_t count)
{
    if (read_short_numbers(to, count)) return true;
    held_ = dropped + position;
    bool good = true;
    for (std::size_t i = 0; good && i < count; ++i) {
        skip_blanks();
        const bool sign = has(0) && (text[position] == '-' || text[position] == '+');
        const bool minus = sign && text[position] == '-';
        if (sign) {
            ++position;
            skip_blanks();
        }
        good = plain_number(to[i]);
        if (minus) to[i] = -to[i];
        if (good) skip_blanks();
        if (good && has(0) && text[position] == ',') ++position;
        else good = good && token().mark != Mark::End;
    }
    if (!good) position = *held_ - dropped;
    held_.reset();
    return good;
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
        if (has(0) && text[position] == ',') ++position;
    }
    if (vector.count < 2) throw std::runtime_error("a vector needs at least two components");
    return vector;
}

bool DataFile::skip_separator() { return token().mark != Mark::End; }

}  // namespace parser
