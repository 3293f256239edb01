#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

namespace parser {

/// Where the time of reading goes: macros, loops and files that are open when a share of tokens is used up get the time
/// since the last. Nothing is counted in between, so it costs nothing that can be measured (a clock every 1024 tokens).
class ReadingProfile {
public:
    enum class What : std::uint8_t { File, Loop, Macro };
    /// A loop is told by its first token, a macro by its name, a file by itself.
    struct Place {
        What what = What::File;
        std::uint16_t file = 0;
        std::uint32_t token = 0;  ///< or name
        friend bool operator==(const Place&, const Place&) = default;
    };
    struct Cost {
        Place place;
        double seconds = 0.0, own_seconds = 0.0;  ///< with all that it calls, and without
    };

    /// The time since the last call belongs to what is open, outermost first; its own to the last of them.
    void spend(std::span<const Place> open);
    /// The most costly, the most costly first. At most `most`.
    std::vector<Cost> costs(std::size_t most) const;
    double total() const { return total_; }  ///< seconds

private:
    using Clock = std::chrono::steady_clock;
    struct Hash {
        std::size_t operator()(const Place& p) const
        {
            return std::hash<std::uint64_t>()((std::uint64_t{p.token} << 24) | (std::uint64_t{p.file} << 2) |
                                              static_cast<std::uint64_t>(p.what));
        }
    };
    struct Times {
        double seconds = 0.0, own_seconds = 0.0;
        std::uint64_t counted = 0;  ///< the last call that it was counted in: once, however deep it calls itself
    };
    Clock::time_point last_ = Clock::now();
    double total_ = 0.0;
    std::uint64_t calls_ = 0;
    std::unordered_map<Place, Times, Hash> times_;
};

}  // namespace parser
