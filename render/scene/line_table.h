#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
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
        starts_.push_back(0);
        if (std::memchr(text.data(), '\r', text.size()) == nullptr) find_line_feeds(text);
        else find_line_ends(text);
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
    void find_line_feeds(std::string_view text)
    {
        for (std::size_t at = 0; at < text.size();) {
            const void* found = std::memchr(text.data() + at, '\n', text.size() - at);
            if (!found) return;
            at = static_cast<std::size_t>(static_cast<const char*>(found) - text.data()) + 1;
            starts_.push_back(static_cast<std::uint32_t>(at));
        }
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
