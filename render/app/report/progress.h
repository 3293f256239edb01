#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>

namespace app {

/// A bar on a terminal; nothing at all when standard error is a pipe or a file. Safe to call from any thread.
class Progress {
public:
    /// pass: what is being done, shown behind the bar; empty: the picture, which needs no word.
    explicit Progress(bool wanted, std::string pass = "");
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress() { clear(); }

    void show(double share);          ///< [0, 1]
    void say(std::string_view text);  ///< a line in the place of the bar
    void clear();                     ///< takes the bar away, so that messages start on a clean line

private:
    void put(const std::string& line);
    using Clock = std::chrono::steady_clock;
    const bool shown_;
    const std::string pass_;
    const Clock::time_point start_ = Clock::now();
    std::atomic<std::int64_t> next_ms_{0};
    std::mutex writing_;
    bool on_screen_ = false;
    std::size_t width_ = 0;  ///< of what stands there
};

}  // namespace app
