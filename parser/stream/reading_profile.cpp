#include "parser/stream/reading_profile.h"

#include <algorithm>

namespace parser {

void ReadingProfile::spend(std::span<const Place> open)
{
    const Clock::time_point now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    total_ += seconds;
    ++calls_;
    for (const Place& place : open) {
        Times& times = times_[place];
        if (times.counted == calls_) continue;
        times.counted = calls_;
        times.seconds += seconds;
    }
    if (!open.empty()) times_[open.back()].own_seconds += seconds;
}

std::vector<ReadingProfile::Cost> ReadingProfile::costs(std::size_t most) const
{
    std::vector<Cost> all;
    for (const auto& [place, times] : times_) all.push_back({place, times.seconds, times.own_seconds});
    std::sort(all.begin(), all.end(), [](const Cost& a, const Cost& b) {
        if (a.seconds != b.seconds) return a.seconds > b.seconds;
        if (a.place.file != b.place.file) return a.place.file < b.place.file;
        return a.place.token < b.place.token;
    });
    all.resize(std::min(all.size(), most));
    return all;
}

}  // namespace parser
