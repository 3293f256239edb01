#include "language/format/edit.h"

#include "language/format/pieces.h"

#include <algorithm>

namespace language::format {
namespace {

bool at_line_end(char c) { return c == '\n' || c == '\r'; }

std::uint32_t line_start(std::string_view text, std::uint32_t at)
{
    while (at > 0 && !at_line_end(text[at - 1])) --at;
    return at;
}

/// The start of its line where nothing but blanks stands before it.
std::optional<std::uint32_t> margin_start(std::string_view text, std::uint32_t at)
{
    const std::uint32_t start = line_start(text, at);
    const bool blank = text.substr(start, at - start).find_first_not_of(" \t") == std::string_view::npos;
    return blank ? std::optional(start) : std::nullopt;
}

std::optional<Edit> unless_same(std::string_view text, Edit edit)
{
    if (text.substr(edit.begin, edit.end - edit.begin) == edit.text) return {};
    return edit;
}

}  // namespace

std::optional<Edit> layout_edit(std::string_view text, const Options& options)
{
    const std::string out = formatted(text, options);
    if (out == text) return {};
    std::size_t front = 0, back = 0;
    const std::size_t shorter = std::min(out.size(), text.size());
    while (front < shorter && out[front] == text[front]) ++front;
    while (front > 0 && !at_line_end(text[front - 1])) --front;
    while (back < shorter - front && out[out.size() - 1 - back] == text[text.size() - 1 - back]) ++back;
    while (back > 0 && !at_line_end(text[text.size() - back - 1])) --back;
    // CR LF is one line end, which no edit may part.
    if (front > 0 && text[front - 1] == '\r') front = line_start(text, static_cast<std::uint32_t>(front) - 1);
    return Edit{static_cast<std::uint32_t>(front), static_cast<std::uint32_t>(text.size() - back),
                out.substr(front, out.size() - back - front)};
}

std::optional<Edit> layout_edit(std::string_view text, std::uint32_t begin, std::uint32_t end, const Options& options)
{
    const std::string out = formatted(text, options);
    const std::vector<Piece> before = pieces_of(text), after = pieces_of(out);
    if (before.size() != after.size()) return {};
    const auto size = static_cast<std::uint32_t>(text.size());
    begin = line_start(text, std::min(begin, size));
    end = std::min(std::max(end, begin), size);
    if (end > begin && at_line_end(text[end - 1])) --end;  // an editor's range of lines ends where the next one begins
    while (end < size && !at_line_end(text[end])) ++end;
    const auto begins = [](const Piece& piece, std::uint32_t at) { return piece.begin < at; };
    const auto first = std::lower_bound(before.begin(), before.end(), begin, begins);
    const auto behind = std::lower_bound(first, before.end(), end, begins);
    if (first == behind) return {};
    const Piece& first_after = after[static_cast<std::size_t>(first - before.begin())];
    const Piece& last_after = after[static_cast<std::size_t>(behind - before.begin()) - 1];
    Edit edit{first->begin, (behind - 1)->end, {}};
    std::uint32_t from = first_after.begin;
    const auto margin = margin_start(text, first->begin), margin_after = margin_start(out, first_after.begin);
    if (margin && margin_after) edit.begin = *margin, from = *margin_after;
    while (edit.end < size && (text[edit.end] == ' ' || text[edit.end] == '\t')) ++edit.end;
    if (edit.end < size && !at_line_end(text[edit.end])) edit.end = (behind - 1)->end;
    edit.text = out.substr(from, last_after.end - from);
    return unless_same(text, std::move(edit));
}

}  // namespace language::format
