#pragma once

#include "numbers/bytes.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string_view>
#include <vector>

namespace scene {

/// Both from 1; column in bytes. Line 0: nowhere.
struct LineAndColumn {
    std::uint32_t line = 0, column = 0;
};

/// Where the lines of a text begin.
class LineTable {
public:
    LineTable() = default;
    explicit LineTable(std::string_view text)
    {
        constexpr std::size_t kShortLine = 16;  // memory that is not written to costs nothing
        starts_.reserve(text.size() / kShortLine + 1);
        starts_.push_back(0);
        if (find_line_feeds(text)) return;
        starts_.resize(1);
        find_line_ends(text);
    }
    bool empty() const { return starts_.empty(); }
    std::uint32_t lines() const { return static_cast<std::uint32_t>(starts_.size()); }
    /// Byte of a line's first character; line from 1 to lines().
    std::uint32_t start(std::uint32_t line) const { return starts_[line - 1]; }
    LineAndColumn place(std::uint32_t offset) const
    {
        if (starts_.empty()) return {};
        const auto line = std::upper_bound(starts_.begin(), starts_.end(), offset) - starts_.begin();
        return {static_cast<std::uint32_t>(line), offset - starts_[static_cast<std::size_t>(line - 1)] + 1};
    }

private:
    /// False: there are other line ends, too. Lines are short: 64 bytes are looked at together.
    bool find_line_feeds(std::string_view text)
    {
        constexpr std::size_t kStep = 64;
        std::size_t at = 0;
        for (; at + kStep <= text.size(); at += kStep) {
            const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data() + at);
            if (numbers::lanes::equal(bytes, '\r') != 0) return false;
            for (std::uint64_t feeds = numbers::lanes::equal(bytes, '\n'); feeds != 0; feeds &= feeds - 1)
                starts_.push_back(
                    static_cast<std::uint32_t>(at + static_cast<std::size_t>(std::countr_zero(feeds)) + 1));
        }
        for (; at < text.size(); ++at) {
            if (text[at] == '\r') return false;
            if (text[at] == '\n') starts_.push_back(static_cast<std::uint32_t>(at + 1));
        }
        return true;
    }
    /// CR LF and LF CR are one line end.
    void find_line_ends(std::string_view text)
    {
        for (std::size_t at = 0; at < text.size(); ++at) {
            const char c = text[at];
            if (c != '\n' && c != '\r') continue;
            if (at + 1 < text.size() && text[at + 1] == (c == '\n' ? '\r' : '\n')) ++at;
            starts_.push_back(static_cast<std::uint32_t>(at + 1));
        }
    }
    std::vector<std::uint32_t> starts_;
};

}  // namespace scene
