#include "parser/stream/expressions/operand.h"
#include "parser/stream/expressions/text_functions.h"
#include "parser/stream/text.h"

#include <fmt/format.h>

#include <cmath>
#include <ctime>

namespace parser {
namespace {

constexpr int kEscapesInPaths = 371;  // language version from which a backslash in a file's name is an escape

std::string read_vstr(TokenStream& stream)
{
    const double count = float_expr(stream);
    stream.accept_comma();
    const Tuple value = untyped_expr(stream);
    stream.accept_comma();
    const std::string separator = string_expr(stream);
    stream.accept_comma();
    const double width = float_expr(stream);
    stream.accept_comma();
    return tuple_text(count, value.at.data(), value.count, separator, width, float_expr(stream));
}

std::string read_substr(TokenStream& stream, const Token& word)
{
    std::string text = string_expr(stream);
    stream.accept_comma();
    const double first = float_expr(stream);
    stream.accept_comma();
    if (!keep_part(text, first, float_expr(stream)))
        stream.fail(stream.place(word), fmt::format("substr reaches outside a text of {} characters", length_of(text)));
    return text;
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
        std::string text;
        if (!text_of_code(float_expr(stream, Level::Full), text))
            stream.fail(stream.place(word), "chr of a number outside 0 to 65535");
        return text;
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
        change_case(text, word.kind == Kind::Strupr);
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
    if (stream.at_name())
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
