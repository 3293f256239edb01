#include "parser/stream/expressions/fixed_text.h"
#include "parser/stream/expressions/operand.h"
#include "parser/stream/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <ctime>

namespace parser {
namespace {

constexpr int kEscapesInPaths = 371;  // language version from which a backslash in a file's name is an escape

/// C's %.*f with leading blanks or zeros, by the quicker ways for numbers of ordinary size.
bool add_plain_number(std::string& to, double value, int width, int precision)
{
    constexpr double kLargest = 1e15;
    constexpr int kMostDecimals = 40, kMostWidth = 60;
    if (!(std::abs(value) < kLargest) || precision > kMostDecimals || std::abs(width) > kMostWidth) return false;
    char digits[80];
    const char* end = digits + kFixedText;
    const char* begin = fixed_text(digits + kFixedText, value, precision);
    if (!begin) {
        begin = digits;
        end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, precision).ptr;
    }
    const auto length = static_cast<std::size_t>(end - begin), wanted = static_cast<std::size_t>(std::abs(width));
    if (length >= wanted) {
        to.append(begin, end);
        return true;
    }
    const bool minus = width < 0 && *begin == '-';
    if (minus) to += *begin++;
    to.append(wanted - length, width < 0 ? '0' : ' ').append(begin, end);
    return true;
}

}  // namespace

void add_number_text(std::string& to, double value, double width_wanted, double precision_wanted)
{
    constexpr int kLongest = 255, kMost = 2 * kLongest;
    const int width = std::clamp(to_int32(width_wanted), -kMost, kMost);
    const int precision = precision_wanted < 0 ? 6 : std::clamp(to_int32(precision_wanted), 0, kMost);
    if (add_plain_number(to, value, width, precision)) return;
    char text[kLongest];
    int length = std::snprintf(text, sizeof text, width < 0 ? "%0*.*f" : "%*.*f", std::abs(width), precision, value);
    if (length >= kLongest)
        length = std::snprintf(text, sizeof text, width < 0 ? "%0*.*g" : "%*.*g", std::abs(width), precision, value);
    if (length >= kLongest) to += "<invalid>";
    else to.append(text, static_cast<std::size_t>(length));
}

std::string number_text(double value, double width_wanted, double precision_wanted)
{
    std::string text;
    add_number_text(text, value, width_wanted, precision_wanted);
    return text;
}

namespace {

std::string read_vstr(TokenStream& stream)
{
    const int count = std::clamp(to_int32(float_expr(stream)), 2, 5);
    stream.accept_comma();
    const Tuple value = untyped_expr(stream);
    stream.accept_comma();
    const std::string separator = string_expr(stream);
    stream.accept_comma();
    const double width = float_expr(stream);
    stream.accept_comma();
    const double precision = float_expr(stream);
    std::string text;
    for (int i = 0; i < count; ++i) {
        if (i > 0) text += separator;
        text += number_text(i < value.count ? value.at[static_cast<std::size_t>(i)] : 0.0, width, precision);
    }
    return text;
}

std::string read_substr(TokenStream& stream, const Token& word)
{
    const std::string text = string_expr(stream);
    stream.accept_comma();
    const int first = to_int32(float_expr(stream));
    stream.accept_comma();
    const int count = to_int32(float_expr(stream));
    const bool plain = is_ascii(text);
    const std::u16string units = plain ? std::u16string() : units_of(text);
    const auto size = static_cast<long>(plain ? text.size() : units.size());
    if (first < 1 || count < 0 || static_cast<long>(first) + count - 1 > size)
        stream.fail(stream.place(word), fmt::format("substr reaches outside a text of {} characters", size));
    const auto begin = static_cast<std::size_t>(first - 1), length = static_cast<std::size_t>(count);
    return plain ? text.substr(begin, length) : from_units(units.substr(begin, length));
}

std::string read_datetime(TokenStream& stream, const Token& word)
{
    const double days = float_expr(stream);
    std::string format = "%Y-%m-%d %H:%M:%SZ";
    stream.accept_comma();
    if (at_string(stream)) format = string_expr(stream);
    constexpr double kSecondsTo2000 = 946684800.0;
    const double seconds = std::floor(days * 86400.0 + kSecondsTo2000 + 0.5);
    constexpr double kFarthest = 6e10;  // seconds; keeps the calendar's year in range
    if (!(std::abs(seconds) < kFarthest)) stream.fail(stream.place(word), "this date is out of range");
    const auto time = static_cast<std::time_t>(seconds);
    std::tm parts{};
    gmtime_r(&time, &parts);
    char text[400];
    const std::size_t length = std::strftime(text, sizeof text, format.c_str(), &parts);
    if (length == 0) stream.fail(stream.place(word), "datetime gives no text");
    return std::string(text, length);
}

std::string read_function(TokenStream& stream, const Token& word)
{
    switch (word.kind) {
    case Kind::Concat: {
        std::string text = string_expr(stream);
        while (stream.accept_comma() || at_string(stream)) text += string_expr(stream);
        return text;
    }
    case Kind::Chr: {
        const double code = float_expr(stream, Level::Full);
        if (!(code >= 0.0 && code < 65536.0)) stream.fail(stream.place(word), "chr of a number outside 0 to 65535");
        const auto unit = static_cast<unsigned>(code);
        if (unit == 0) return {};
        return from_units(std::u16string(1, static_cast<char16_t>(unit)));
    }
    case Kind::Str: {
        const double value = float_expr(stream);
        stream.accept_comma();
        const double width = float_expr(stream);
        stream.accept_comma();
        return number_text(value, width, float_expr(stream));
    }
    case Kind::Vstr: return read_vstr(stream);
    case Kind::Substr: return read_substr(stream, word);
    case Kind::Datetime: return read_datetime(stream, word);
    default: {
        std::string text = string_expr(stream);
        if (!is_ascii(text)) stream.warn(stream.place(word), "only letters of ASCII change their case");
        for (char& c : text) {
            if (word.kind == Kind::Strupr && c >= 'a' && c <= 'z') c = static_cast<char>(c - 32);
            if (word.kind == Kind::Strlwr && c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
        }
        return text;
    }
    }
}

std::string read_string(TokenStream& stream, bool path)
{
    const auto guard = stream.nest();
    const Token token = stream.peek();
    if (token.kind == Kind::String) return stream.string_text(stream.next(), path);
    if (lexical_class(token.kind) == LexicalClass::String) {
        stream.next();
        const bool raw = stream.raw_operators();
        stream.set_raw_operators(false);
        stream.expect(Kind::LeftParen, "'(' after the function's name");
        std::string text = read_function(stream, token);
        stream.expect(Kind::RightParen, "')' after the function's arguments");
        stream.set_raw_operators(raw);
        return text;
    }
    if (token.kind == Kind::Identifier)
        if (auto text = stream.accept_identifier<std::string>()) return *text;
    stream.fail_expected("a text, as in \"name\"");
}

}  // namespace

std::string string_expr(TokenStream& stream) { return read_string(stream, false); }

std::string path_expr(TokenStream& stream) { return read_string(stream, true); }

std::string TokenStream::string_text(const Token& token, bool path)
{
    const std::string& raw = files_[token.file]->strings[token.name];
    if (path && language_.version < kEscapesInPaths) return raw;
    if (!path && language_.charset == Charset::System)
        fail(place(token), "texts in the charset 'sys' cannot be read here");
    const bool plain = is_ascii(raw);
    if (plain && raw.find('\\') == std::string::npos) return raw;
    if (!plain && !path && language_.charset == Charset::Ascii && language_.version >= 350)
        warn(place(token), "characters outside of ASCII are taken as blanks; see 'charset' in global_settings");

    std::string text, bytes;  // bytes: up to the next escape, not yet in the form of texts
    const auto finish_bytes = [&] {
        if (path) text += bytes;
        else if (language_.charset == Charset::Utf8) text += from_utf8_bytes(bytes);
        else text += language_.version < 350 ? from_latin1(bytes) : printed(from_latin1(bytes), language_.version);
        bytes.clear();
    };
    for (std::size_t i = 0; i < raw.size(); ++i) {
        if (raw[i] != '\\' || i + 1 == raw.size()) {
            bytes += raw[i];
            continue;
        }
        finish_bytes();
        const char c = raw[++i];
        if (c == 'u') {
            if (i + 4 >= raw.size()) fail(place(token), "\\u needs four hexadecimal digits");
            const unsigned long code = std::strtoul(raw.substr(i + 1, 4).c_str(), nullptr, 16);
            text += from_units(std::u16string(1, static_cast<char16_t>(code)));
            i += 4;
            continue;
        }
        const char plain_char = escaped(c);
        if (plain_char == 0) fail(place(token), fmt::format("'\\{}' means nothing in a text", c));
        text += plain_char;
    }
    finish_bytes();
    return text;
}

}  // namespace parser
