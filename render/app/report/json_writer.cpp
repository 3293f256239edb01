#include "render/app/report/json_writer.h"

#include <fmt/format.h>

namespace app {

namespace {

/// Bytes of the UTF-8 character that begins at `at`; 0 if it is none.
std::size_t character_length(std::string_view text, std::size_t at)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(text[i])); };
    const unsigned lead = byte(at);
    const std::size_t length = lead < 0x80                   ? 1
                               : lead >= 0xC2 && lead < 0xE0 ? 2
                               : lead >= 0xE0 && lead < 0xF0 ? 3
                               : lead >= 0xF0 && lead < 0xF5 ? 4
                                                             : 0;
    if (length == 0 || at + length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(at + i) & 0xC0u) != 0x80u) return 0;
    if (length < 3) return length;
    // Too long for its value, a surrogate, or beyond the last character.
    const unsigned second = byte(at + 1);
    if ((lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F) || (lead == 0xF0 && second < 0x90) ||
        (lead == 0xF4 && second > 0x8F))
        return 0;
    return length;
}

}  // namespace

std::string json_quoted(std::string_view text)
{
    std::string out = "\"";
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = character_length(text, i);
        const char c = text[i];
        if (length == 0) out += "\\ufffd";
        else if (c == '"' || c == '\\') (out += '\\') += c;
        else if (c == '\n') out += "\\n";
        else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            out += fmt::format("\\u{:04x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
        else out += text.substr(i, length);
        i += length == 0 ? 1 : length;
    }
    return out + "\"";
}

void JsonWriter::new_line() { (out_ += '\n').append(2 * closing_.size(), ' '); }

void JsonWriter::item(std::string_view text)
{
    if (!after_key_ && !closing_.empty()) {
        if (!first_) out_ += ',';
        new_line();
    }
    out_ += text;
    first_ = after_key_ = false;
}

void JsonWriter::open(char bracket)
{
    item(std::string_view(&bracket, 1));
    closing_ += bracket == '{' ? '}' : ']';
    first_ = true;
}

void JsonWriter::close()
{
    const char bracket = closing_.back();
    closing_.pop_back();
    if (!first_) new_line();
    out_ += bracket;
    first_ = false;
}

JsonWriter& JsonWriter::key(std::string_view name)
{
    item(json_quoted(name));
    out_ += ": ";
    after_key_ = true;
    return *this;
}

void JsonWriter::text(std::string_view value) { item(json_quoted(value)); }

void JsonWriter::number(double value)
{
    if (std::isfinite(value)) item(fmt::format("{}", value));
    else null();
}

}  // namespace app
