#include "parser/stream/text.h"

#include <cstdint>
#include <cstring>

namespace parser {
namespace {

constexpr char32_t kReplacement = 0xFFFD;

void append(std::string& to, char32_t code)
{
    if (code < 0x80) {
        to += static_cast<char>(code);
    } else if (code < 0x800) {
        to += static_cast<char>(0xC0 | code >> 6);
        to += static_cast<char>(0x80 | (code & 0x3F));
    } else {
        to += static_cast<char>(0xE0 | code >> 12);
        to += static_cast<char>(0x80 | (code >> 6 & 0x3F));
        to += static_cast<char>(0x80 | (code & 0x3F));
    }
}

/// The character at `at`, which moves behind it.
char32_t decode(std::string_view text, std::size_t& at)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(at++);
    if (first < 0x80) return first;
    const unsigned more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
    if (more == 0) return kReplacement;
    char32_t code = first & (0x3Fu >> more);
    for (unsigned i = 0; i < more; ++i) {
        if (at >= text.size() || (byte(at) & 0xC0) != 0x80) return kReplacement;
        code = code << 6 | (byte(at++) & 0x3F);
    }
    return code > 0xFFFF ? kReplacement : code;
}

}  // namespace

bool is_ascii(std::string_view text)
{
    const char* at = text.data();
    const char* const end = at + text.size();
    std::uint64_t bits = 0;
    for (; end - at >= 8; at += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, at, 8);
        bits |= word;
    }
    for (; at != end; ++at) bits |= static_cast<unsigned char>(*at);
    return (bits & 0x8080808080808080u) == 0;
}

std::u16string units_of(std::string_view text)
{
    std::u16string units;
    units.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) units += static_cast<char16_t>(decode(text, at));
    return units;
}

std::string from_units(std::u16string_view units)
{
    std::string text;
    for (const char16_t unit : units) append(text, unit);
    return text;
}

std::string from_utf8_bytes(std::string_view bytes)
{
    return is_ascii(bytes) ? std::string(bytes) : from_units(units_of(bytes));
}

std::string from_latin1(std::string_view bytes)
{
    std::string text;
    for (const char c : bytes) append(text, static_cast<unsigned char>(c));
    return text;
}

std::string printed(std::string text, int version)
{
    if (is_ascii(text)) return text;
    std::string bytes;
    for (const char16_t unit : units_of(text))
        bytes += static_cast<char>(unit < 0x80 ? unit : version >= 350 ? ' ' : unit & 0xFF);
    return bytes;
}

char escaped(char c)
{
    switch (c) {
    case 'a': return '\a';
    case 'b': return '\b';
    case 'f': return '\f';
    case 'n': return '\n';
    case 'r': return '\r';
    case 't': return '\t';
    case 'v': return '\v';
    case '\\':
    case '\'':
    case '"': return c;
    default: return 0;
    }
}

}  // namespace parser
