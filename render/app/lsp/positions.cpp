#include "render/app/lsp/positions.h"

#include <algorithm>

namespace app::lsp {
namespace {

/// UTF-16 units of the character that begins with a byte; 0 for the bytes that follow in it.
std::uint32_t units(char byte)
{
    const auto value = static_cast<unsigned char>(byte);
    if ((value & 0xC0u) == 0x80u) return 0;
    return value >= 0xF0 ? 2 : 1;
}

}  // namespace

Positions::Positions(std::string_view text, Encoding encoding) : text_(text), encoding_(encoding), starts_{0}
{
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] != '\n' && (text[at] != '\r' || (at + 1 < text.size() && text[at + 1] == '\n'))) continue;
        starts_.push_back(static_cast<std::uint32_t>(at + 1));
    }
}

std::size_t Positions::line_of(std::uint32_t offset) const
{
    return static_cast<std::size_t>(std::upper_bound(starts_.begin(), starts_.end(), offset) - starts_.begin()) - 1;
}

language::Range Positions::line(std::size_t line) const
{
    if (line >= starts_.size())
        return {static_cast<std::uint32_t>(text_.size()), static_cast<std::uint32_t>(text_.size())};
    std::uint32_t end = line + 1 < starts_.size() ? starts_[line + 1] : static_cast<std::uint32_t>(text_.size());
    while (end > starts_[line] && (text_[end - 1] == '\n' || text_[end - 1] == '\r')) --end;
    return {starts_[line], end};
}

json Positions::position(std::uint32_t offset) const
{
    offset = std::min(offset, static_cast<std::uint32_t>(text_.size()));
    const std::size_t line = line_of(offset);
    std::uint32_t character = offset - starts_[line];
    if (encoding_ == Encoding::Utf16) {
        character = 0;
        for (std::uint32_t at = starts_[line]; at < offset; ++at) character += units(text_[at]);
    }
    return {{"line", line}, {"character", character}};
}

json Positions::range(language::Range range) const
{
    return {{"start", position(range.begin)}, {"end", position(range.end)}};
}

std::uint32_t Positions::offset(const json& position) const
{
    const std::uint32_t wanted_line = count_member(position, "line");
    const std::uint32_t character = count_member(position, "character");
    const auto [begin, end] = line(wanted_line);
    std::uint32_t at = begin;
    if (encoding_ == Encoding::Utf8) {
        at = begin + std::min(character, end - begin);
        while (at > begin && at < end && units(text_[at]) == 0) --at;  // within a character: before it
        return at;
    }
    for (std::uint32_t passed = 0; at < end; ++at) {
        passed += units(text_[at]);
        if (passed > character) break;
    }
    return at;
}

language::Range Positions::range(const json& range) const
{
    const std::uint32_t begin = offset(object_member(range, "start")), end = offset(object_member(range, "end"));
    return {std::min(begin, end), std::max(begin, end)};
}

}  // namespace app::lsp
