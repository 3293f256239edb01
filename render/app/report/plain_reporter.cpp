#include "render/app/report/plain_reporter.h"

#include <fmt/format.h>

namespace app {

void PlainReporter::begin(const FrameFacts& facts)
{
    width_ = facts.settings.width;
    height_ = facts.settings.height;
    if (facts.list.animation)
        put(Stream::Render,
            fmt::format("frame {} of {}, clock {:g}\n", facts.frame.number, facts.list.last_frame, facts.frame.clock));
}

void PlainReporter::still_reading(const parser::ReadingPlace& where, double seconds)
{
    if (!bar_) bar_.emplace(with_bar_);
    const std::string what = where.what == "file" ? where.name
                                                  : fmt::format("{} {}, {}", where.what, where.name, where.place);
    bar_->say(fmt::format("reading, {:.0f} s: in {}", seconds, what));
}

void PlainReporter::message(const scene::Message& message)
{
    using scene::Severity;
    if (bar_) bar_->clear();
    const std::string text = message_text(message);
    if (message.severity == Severity::Debug) return put(Stream::Debug, text);
    const Stream stream = message.severity == Severity::Error ? Stream::Fatal : Stream::Warning;
    put(stream, text.ends_with('\n') ? text : text + "\n");
}

void PlainReporter::rendered(const StageTimes& times, const trace::RenderStatistics& statistics)
{
    put(Stream::Statistic, report_text(times, statistics));
}

void PlainReporter::written(const std::string& path)
{
    bar_.reset();
    put(Stream::Render, fmt::format("{}  {}x{}\n", path, width_, height_));
}

void PlainReporter::skipped(const std::string& path)
{
    put(Stream::Render, fmt::format("{} exists and continue was asked for: skipped\n", path));
}

void PlainReporter::note(const std::string& text) { put(Stream::Warning, "note: " + text + "\n"); }

void PlainReporter::cancelled(const Kept& kept)
{
    bar_.reset();
    put(Stream::Lines,
        kept.state.empty()
            ? "cancelled: no picture written\n"
            : fmt::format("cancelled: no picture written; {} holds the finished part, +C continues\n", kept.state));
    if (!kept.picture.empty()) put(Stream::Lines, fmt::format("{} shows it\n", kept.picture));
}

void PlainReporter::failed(const std::vector<scene::Message>& errors)
{
    bar_.reset();
    std::string all;
    for (const scene::Message& error : errors)
        all += (error.place.path.empty() ? "whittle: " : "") + message_text(error) + "\n";
    put(Stream::Fatal, all);
}

}  // namespace app
