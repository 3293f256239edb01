#pragma once

#include "render/app/report/console_reporter.h"

#include <mutex>
#include <string>

namespace app {

/// Hands a run on to the reporter that speaks to the user, and tells a program of its progress (--progress): a line
/// each, unbuffered, on standard error, which the engines of farms read together with standard output.
class ProgressTeller final : public ConsoleReporter {
public:
    ProgressTeller(Streams& streams, ConsoleReporter& speaker, const Settings& settings)
        : ConsoleReporter(streams), speaker_(speaker), dialect_(settings.progress),
          frames_(frames_of(settings).frames.size())
    {}

    void begin(const FrameFacts& facts) override;
    void message(const scene::Message& message) override { speaker_.message(message); }
    void parsed(const parser::Result& result, const StageTimes& times) override { speaker_.parsed(result, times); }
    void still_reading(const parser::ReadingPlace& where, double seconds) override
    {
        speaker_.still_reading(where, seconds);
    }
    void rendering() override;
    void pass(const std::string& name) override;
    void progress(double share) override;
    void rendered(const StageTimes& times, const trace::RenderStatistics& statistics) override;
    void written(const std::string& path) override { speaker_.written(path); }
    void skipped(const std::string& path) override;
    void note(const std::string& text) override { speaker_.note(text); }
    void cancelled(const Kept& kept) override;
    void failed(const std::vector<scene::Message>& errors) override;
    void finished() override;

private:
    void tell(double percent);
    void status(const std::string& text);
    void frame_done();

    ConsoleReporter& speaker_;
    const ProgressLines dialect_;
    const std::size_t frames_;  ///< of the run
    std::mutex writing_;
    std::string frame_;        ///< "frame 3", or "picture"
    std::size_t done_ = 0;     ///< of them
    double pixels_ = 0.0;      ///< of a frame
    bool in_picture_ = false;  ///< and not in a pass before it
    int told_ = -1;            ///< tenths of a percent
};

/// The line that tells why a run failed; empty where a dialect has none.
std::string failure_line(ProgressLines dialect, const std::string& text);

}  // namespace app
