#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>

namespace app {

/// A bar on a terminal; nothing at all when standard error is a pipe or a file. Safe to call from any thread.
class Progress {
public:
    explicit Progress(bool wanted);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress() { clear(); }

    void show(double share);  ///< [0, 1]
    void clear();             ///< takes the bar away, so that messages start on a clean line

private:
    using Clock = std::chrono::steady_clock;
    const bool shown_;
    const Clock::time_point start_ = Clock::now();
    std::atomic<std::int64_t> next_ms_{0};
    std::mutex writing_;
    bool on_screen_ = false;
};

}  // namespace app
