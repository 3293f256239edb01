#include "parser/stream/texts/quoted_text.h"

#include <algorithm>

namespace parser {
namespace {

constexpr std::size_t kLongestLine = 110;  // of a quoted source line, in bytes

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }

/// Length of the well-formed UTF-8 character beyond ASCII at `at`, control characters excluded; 0: there is none.
std::size_t character_length(std::string_view text, std::size_t at)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[at + i]); };
    const std::size_t length = byte(0) >= 0xF0 && byte(0) <= 0xF4  ? 4
                               : byte(0) >= 0xE0 && byte(0) < 0xF0 ? 3
                               : byte(0) >= 0xC2 && byte(0) < 0xE0 ? 2
                                                                   : 0;
    if (length == 0 || at + length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if (!continues(text[at + i])) return 0;
    const unsigned char second = byte(1);
    const bool control = byte(0) == 0xC2 && second < 0xA0;
    const bool too_long = (byte(0) == 0xE0 && second < 0xA0) || (byte(0) == 0xF0 && second < 0x90);
    const bool outside = (byte(0) == 0xED && second >= 0xA0) || (byte(0) == 0xF4 && second >= 0x90);
    return control || too_long || outside ? 0 : length;
}

}  // namespace

std::string printable(std::string_view text)
{
    std::string out;
    out.reserve(text.size());
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '\t' || (c >= ' ' && c <= '~')) {
            out += c;
        } else if (const std::size_t length = character_length(text, at)) {
            out += text.substr(at, length);
            at += length - 1;
        } else {
            out += '?';
        }
    }
    return out;
}

std::size_t character_start(std::string_view text, std::size_t at)
{
    while (at > 0 && at < text.size() && continues(text[at])) --at;
    return std::min(at, text.size());
}

scene::QuotedLine quoted_line(const SourceFile& file, const scene::LineAndColumn& at)
{
    const auto [line, column] = at;
    std::string source = printable(file.line_text(line));  // as many bytes
    std::size_t caret = column - 1;
    if (source.size() > kLongestLine) {
        const std::size_t cut =
            character_start(source, caret > kLongestLine / 2 ? std::min(caret - kLongestLine / 2, source.size()) : 0);
        source = source.substr(cut, character_start(std::string_view(source).substr(cut), kLongestLine));
        caret -= cut;
    }
    std::string below;  // a blank a character
    for (std::size_t i = 0; i < caret; ++i)
        if (i >= source.size() || !continues(source[i])) below += i < source.size() && source[i] == '\t' ? '\t' : ' ';
    return {std::move(source), std::move(below)};
}

}  // namespace parser
