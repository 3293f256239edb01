#include "render/app/report/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>

namespace app {

namespace {

constexpr int kWidth = 40;               // columns of the bar
constexpr std::int64_t kPeriodMs = 100;  // between two updates

}  // namespace

Progress::Progress(bool wanted) : shown_(wanted && isatty(STDERR_FILENO) != 0) {}

void Progress::show(double share)
{
    if (!shown_) return;
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    const auto now_ms = static_cast<std::int64_t>(seconds * 1000.0);
    std::int64_t due = next_ms_.load();
    if (now_ms < due || !next_ms_.compare_exchange_strong(due, now_ms + kPeriodMs)) return;
    const int filled = std::clamp(static_cast<int>(share * kWidth), 0, kWidth);
    const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                            std::string(static_cast<std::size_t>(kWidth - filled), '.');
    const std::lock_guard lock(writing_);
    fmt::print(stderr, "\r[{}] {:3.0f} %  {:.1f} s", bar, share * 100.0, seconds);
    std::fflush(stderr);
    on_screen_ = true;
}

void Progress::clear()
{
    const std::lock_guard lock(writing_);
    if (!on_screen_) return;
    fmt::print(stderr, "\r{:{}}\r", "", kWidth + 24);
    on_screen_ = false;
}

}  // namespace app
