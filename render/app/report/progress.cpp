#include "render/app/report/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>

namespace app {

namespace {

constexpr int kWidth = 40;               // columns of the bar
constexpr std::int64_t kPeriodMs = 100;  // between two updates

/// Time left at the same pace: told when there is a pace to go by.
std::string left(double share, double seconds)
{
    constexpr double kFewest = 0.5, kLeast = 0.02;
    if (seconds < kFewest || share < kLeast || share >= 1.0) return "";
    const double rest = seconds * (1.0 - share) / share;
    return rest < 100.0 ? fmt::format(", {:.0f} s left", rest) : fmt::format(", {:.0f} min left", rest / 60.0);
}

}  // namespace

Progress::Progress(bool wanted, std::string pass) : shown_(wanted && isatty(STDERR_FILENO) != 0), pass_(std::move(pass))
{}

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
    put(fmt::format("[{}] {:3.0f} %  {:.1f} s{}{}{}", bar, share * 100.0, seconds, left(share, seconds),
                    pass_.empty() ? "" : "  ", pass_));
}

void Progress::say(std::string_view text)
{
    if (!shown_) return;
    // A line that wraps could not be taken away again.
    winsize window{};
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col > 1;
    const std::size_t columns = known ? window.ws_col - 1u : 79u;
    put(std::string(text.substr(0, columns)));
}

void Progress::put(const std::string& line)
{
    const std::lock_guard lock(writing_);
    const std::size_t longest = std::max(width_, line.size());
    fmt::print(stderr, "\r{:{}}", line, longest);  // over what a longer line before it left
    width_ = line.size();
    std::fflush(stderr);
    on_screen_ = true;
}

void Progress::clear()
{
    const std::lock_guard lock(writing_);
    if (!on_screen_) return;
    fmt::print(stderr, "\r{:{}}\r", "", width_);
    on_screen_ = false;
}

}  // namespace app
