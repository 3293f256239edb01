#include "render/app/report/povray_reporter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace app {

namespace {

constexpr int kLineLength = 76;                            // of rules and headings
constexpr std::chrono::milliseconds kBetweenUpdates{100};  // on a terminal

constexpr int kFrameStep = 20;  // percent between updates in an animation, on a pipe

std::string heading(const std::string& text)
{
    return fmt::format("{:=<{}}\n", fmt::format("==== [{}...] ", text), kLineLength);
}
std::string rule()
{
    std::string line(kLineLength, '-');
    line += '\n';
    return line;
}
std::string titled(const char* title) { return rule() + title + "\n" + rule(); }

std::string duration(double seconds)
{
    const long long whole = static_cast<long long>(seconds);
    return fmt::format("{} hours {:2} minutes {:2} seconds ({:.3f} seconds)", whole / 3600, whole / 60 % 60, whole % 60,
                       seconds);
}

double seconds_of(const StageTimes& times, std::string_view stage)
{
    double sum = 0.0;
    for (const StageTimes::Stage& s : times.stages())
        if (s.name == stage) sum += s.seconds;
    return sum;
}

}  // namespace

std::string povray_text(const scene::Message& message, const char* plain)
{
    using scene::Severity;
    const std::size_t end = std::min(message.text.find('\n'), message.text.size());
    const std::string words = message.text.substr(0, end), place = place_text(message.place);
    std::string out;
    if (place.empty()) out = fmt::format("{}: {}\n", plain, words);
    else if (message.place.at.line == 0)
        out = fmt::format("{}: {}: {}: {}\n", plain, place, name_of(message.severity), words);
    else if (message.severity == Severity::Note) out = fmt::format(" {}: note: {}\n", place, words);
    else
        out = fmt::format("File '{}' line {}: Parse {}: {}\n at column {}\n", message.place.path, message.place.at.line,
                          message.severity == Severity::Error ? "Error" : "Warning", words, message.place.at.column);
    // What follows the words of the message as the console of our own has it.
    const std::string all = message_text(message);
    const std::size_t head = all.find('\n');
    if (head == std::string::npos) return out;
    std::istringstream lines(all.substr(head + 1));
    for (std::string line; std::getline(lines, line);)
        out += fmt::format("{}{}\n", line.starts_with(' ') ? "" : " ", line);
    return out;
}

void PovrayReporter::begin(const FrameFacts& f)
{
    const Settings& s = f.settings;
    std::string text = "\nParser Options\n";
    text += fmt::format("  Input file: {}\n  Library paths:\n", f.scene);
    for (const std::string& folder : s.library_path) text += "    " + folder + "\n";
    if (!f.list.animation) text += fmt::format("  Clock value:    {:.3f}  (Animation off)\n", f.frame.clock);
    else
        text += fmt::format(
            "Animation Options\n  Initial Frame: {:8}  Final Frame: {:8}\n  Frame: {}  Clock value: {:.3f}\n",
            f.list.initial_frame, f.list.last_frame, f.frame.number, f.frame.clock);
    text += "Image Output Options\n";
    text += fmt::format("  Image resolution.....{} by {} (rows {} to {}, columns {} to {}).\n", s.width, s.height,
                        f.window.first_row + 1, f.window.last_row + 1, f.window.first_column + 1,
                        f.window.last_column + 1);
    if (!f.picture.empty()) text += fmt::format("  Output file..........{}\n", f.picture);
    text += fmt::format("  Continued trace......{}\n", s.continue_trace ? "On" : "Off");
    put(Stream::Render, text);
    put(Stream::Lines, heading("Parsing"));
    const long long width = f.window.last_column - f.window.first_column + 1,
                    height = f.window.last_row - f.window.first_row + 1;
    pixels_ = std::max(width, 0LL) * std::max(height, 0LL);
    percent_ = -1;
    step_ = f.list.animation ? kFrameStep : 1;
    parsing_ = true;
}

void PovrayReporter::message(const scene::Message& message)
{
    using scene::Severity;
    switch (message.severity) {
    case Severity::Debug: return put(Stream::Debug, message.text);
    case Severity::Error: return put(Stream::Fatal, povray_text(message, "Parse Error"));
    case Severity::Note: return put(Stream::Warning, povray_text(message, "Note"));
    case Severity::Warning: return put(Stream::Warning, povray_text(message, "Parse Warning"));
    }
}

void PovrayReporter::parsed(const parser::Result& result, const StageTimes& times)
{
    parsing_ = false;
    const auto lights = std::count_if(result.scene.objects.begin(), result.scene.objects.end(), scene::is_light);
    const auto all = static_cast<long long>(result.scene.objects.size());
    put(Stream::Statistic,
        titled("Parser Statistics") +
            fmt::format("Objects:           {:10}\nLight Sources:     {:10}\nTotal:             {:10}\n", all - lights,
                        lights, all) +
            rule() + fmt::format("Parser Time\n  Parse Time:       {}\n", duration(seconds_of(times, "parse"))) +
            rule());
}

void PovrayReporter::rendering() { put(Stream::Lines, heading("Rendering")); }

/// POV-Ray counts the pixels anew in each pass over the picture and has no word for them.
void PovrayReporter::pass(const std::string&)
{
    const std::lock_guard lock(writing_);
    percent_ = -1;
}

void PovrayReporter::progress(double share)
{
    if (!verbose_) return;
    const int percent = static_cast<int>(std::floor(share * 100.0));
    const std::lock_guard lock(writing_);
    // A pipe gets at most one line per percent, in animations fewer, so that one that nobody reads does not soon fill;
    // a terminal gets a steady pace.
    const Clock::time_point now = Clock::now();
    const bool due = percent_ < 0 || percent >= percent_ + step_ || (percent >= 100 && percent_ < 100);
    if (percent <= percent_ || (!terminal() && !due) || (terminal() && percent < 100 && now - shown_ < kBetweenUpdates))
        return;
    percent_ = percent;
    shown_ = now;
    put(Stream::Lines, fmt::format("Rendered {} of {} pixels ({}%)\r",
                                   std::llround(share * static_cast<double>(pixels_)), pixels_, percent));
}

void PovrayReporter::rendered(const StageTimes& times, const trace::RenderStatistics& statistics)
{
    if (percent_ >= 0) put(Stream::Lines, "\n");
    const trace::RayCounts& rays = statistics.rays;
    std::string text = titled("Render Statistics");
    text += fmt::format("Pixels:       {:10}   Samples:      {:10}\n", pixels_, rays.supersamples);
    text += fmt::format("Rays:         {:10}\n", rays.camera + rays.reflected + rays.refracted);
    text += fmt::format("Shadow Ray Tests:   {:10}\nReflected Rays:     {:10}\nRefracted Rays:     {:10}\n",
                        rays.shadow, rays.reflected, rays.refracted);
    text += rule() + "Render Time:\n  Photon Time:      No photons\n  Radiosity Time:   No radiosity\n";
    text += fmt::format("  Trace Time:       {}\n              using {} thread(s)\n",
                        duration(seconds_of(times, "trace")), statistics.threads);
    put(Stream::Statistic, text);
}

void PovrayReporter::skipped(const std::string& path)
{
    put(Stream::Render, fmt::format("File '{}' already rendered and continue requested; skipping.\n", path));
}

void PovrayReporter::note(const std::string& text) { put(Stream::Warning, "Note: " + text + "\n"); }

void PovrayReporter::cancelled(const Kept& kept)
{
    if (percent_ >= 0) put(Stream::Lines, "\n");
    if (!kept.state.empty())
        put(Stream::Render, fmt::format("The finished part is in '{}'; +C continues.\n", kept.state));
    if (!kept.picture.empty()) put(Stream::Render, fmt::format("'{}' shows it.\n", kept.picture));
    put(Stream::Fatal, "Fatal error in renderer: Frontend halted render.\n");
    put(Stream::Lines, "Render cancelled by user\n\n");
}

void PovrayReporter::failed(const std::vector<scene::Message>& errors)
{
    if (percent_ >= 0) put(Stream::Lines, "\n");
    std::string all;
    for (const scene::Message& error : errors) all += povray_text(error, parsing_ ? "Parse Error" : "Fatal error");
    put(Stream::Fatal, all);
    if (parsing_) put(Stream::Lines, "Fatal error in parser: Cannot parse input.\n");
    put(Stream::Lines, "Render failed\n\n");
}

void PovrayReporter::finished() { put(Stream::Lines, "POV-Ray finished\n\n"); }

}  // namespace app
