#include "render/app/watch/place/number_edits.h"

#include <fmt/format.h>

namespace app {

std::string number_text(double value) { return fmt::format("{:.6g}", value); }

std::string edited(const std::string& text, const NumberEdits& edits)
{
    std::string out;
    std::size_t from = 0;
    for (const auto& [begin, number] : edits.numbers) {
        if (begin < from || number.end > text.size()) continue;
        out.append(text, from, begin - from);
        out += number_text(number.value);
        from = number.end;
    }
    return out.append(text, from);
}

std::uint32_t edited_place(std::uint32_t offset, const NumberEdits& edits)
{
    std::int64_t out = offset;
    for (const auto& [begin, number] : edits.numbers) {
        if (begin >= offset) break;
        const auto before = static_cast<std::int64_t>(number.end - begin);
        const auto after = static_cast<std::int64_t>(number_text(number.value).size());
        // Within the number it stays at its start.
        out += offset < number.end ? static_cast<std::int64_t>(begin) - offset : after - before;
    }
    return static_cast<std::uint32_t>(out);
}

std::uint32_t written_place(std::uint32_t offset, const NumberEdits& edits)
{
    std::int64_t longer = 0;  // the edited text than the file, so far
    for (const auto& [begin, number] : edits.numbers) {
        const std::int64_t start = begin + longer;
        if (start >= offset) break;
        const auto length = static_cast<std::int64_t>(number_text(number.value).size());
        if (offset < start + length) return begin;
        longer += length - static_cast<std::int64_t>(number.end - begin);
    }
    return static_cast<std::uint32_t>(offset - longer);
}

}  // namespace app
