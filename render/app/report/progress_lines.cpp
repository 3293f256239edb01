#include "render/app/report/progress_lines.h"

#include "render/app/report/json_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace app {
namespace {

/// Between two lines, in tenths of a percent: a thousand lines say no more, and a pipe that nobody reads would fill.
constexpr int kStep = 5;

void put_line(const std::string& line)
{
    if (line.empty()) return;
    std::fputs((line + "\n").c_str(), stderr);
    std::fflush(stderr);
}

/// One member, and no line break within the line.
std::string object_of(const char* key, const std::string& text)
{
    return fmt::format("{{\"{}\": {}}}", key, json_quoted(text));
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

std::string failure_line(ProgressLines dialect, const std::string& text)
{
    switch (dialect) {
    case ProgressLines::Json: return object_of("fail", first_line(text));
    case ProgressLines::OpenJd: return "openjd_fail: " + first_line(text);
    case ProgressLines::Povray:
    case ProgressLines::None: break;
    }
    return {};
}

void ProgressTeller::tell(double percent)
{
    const std::lock_guard lock(writing_);
    const int tenths = static_cast<int>(std::floor(percent * 10.0));
    if (tenths < told_ + kStep && !(tenths >= 1000 && told_ < 1000)) return;
    told_ = tenths;
    const double rounded = tenths / 10.0;
    if (dialect_ == ProgressLines::Json) put_line(fmt::format("{{\"percent\": {:.1f}}}", rounded));
    if (dialect_ == ProgressLines::OpenJd) put_line(fmt::format("openjd_progress: {:.1f}", rounded));
    if (dialect_ == ProgressLines::Povray) {
        const double all = pixels_ * static_cast<double>(frames_);
        put_line(fmt::format("Rendered {} of {} pixels ({}%)", std::llround(all * rounded / 100.0), std::llround(all),
                             tenths / 10));
    }
}

void ProgressTeller::status(const std::string& text)
{
    const std::lock_guard lock(writing_);
    if (dialect_ == ProgressLines::Json) put_line(object_of("status", text));
    if (dialect_ == ProgressLines::OpenJd) put_line("openjd_status: " + text);
}

void ProgressTeller::begin(const FrameFacts& facts)
{
    speaker_.begin(facts);
    frame_ = facts.list.animation ? fmt::format("frame {}", facts.frame.number) : "picture";
    const Window& w = facts.window;
    pixels_ = static_cast<double>(w.last_column - w.first_column + 1) * (w.last_row - w.first_row + 1);
    in_picture_ = false;
    status(frame_ + ": reading");
    tell(100.0 * static_cast<double>(done_) / static_cast<double>(frames_));
}

void ProgressTeller::rendering()
{
    speaker_.rendering();
    in_picture_ = true;
    status(frame_ + ": rendering");
}

void ProgressTeller::pass(const std::string& name)
{
    speaker_.pass(name);
    in_picture_ = name == "picture";
    status(frame_ + ": " + name);
}

void ProgressTeller::progress(double share)
{
    speaker_.progress(share);
    if (in_picture_) tell(100.0 * (static_cast<double>(done_) + share) / static_cast<double>(frames_));
}

void ProgressTeller::frame_done()
{
    done_ = std::min(done_ + 1, frames_);  // of one frame many views may be skipped
    tell(100.0 * static_cast<double>(done_) / static_cast<double>(frames_));
}

void ProgressTeller::rendered(const StageTimes& times, const trace::RenderStatistics& statistics)
{
    speaker_.rendered(times, statistics);
    frame_done();
}

void ProgressTeller::skipped(const std::string& path)
{
    speaker_.skipped(path);
    frame_done();
}

void ProgressTeller::cancelled(const Kept& kept)
{
    speaker_.cancelled(kept);
    status(kept.state.empty() ? "cancelled" : "cancelled; +C goes on from " + kept.state);
}

void ProgressTeller::failed(const std::vector<scene::Message>& errors)
{
    speaker_.failed(errors);
    const std::lock_guard lock(writing_);
    put_line(failure_line(dialect_, errors.empty() ? "failed" : message_text(errors.front())));
}

void ProgressTeller::finished()
{
    speaker_.finished();
    status("done");
}

}  // namespace app
