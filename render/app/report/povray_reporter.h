#pragma once

#include "render/app/report/console_reporter.h"

#include <atomic>
#include <chrono>
#include <mutex>

namespace app {

/// The lines of POV-Ray's console that other programs look for (tests/render/app/callers.cpp), in its order.
class PovrayReporter final : public ConsoleReporter {
public:
    PovrayReporter(Streams& streams, bool verbose) : ConsoleReporter(streams), verbose_(verbose) {}

    void begin(const FrameFacts& facts) override;
    void message(const scene::Message& message) override;
    void still_reading(const parser::ReadingPlace&, double) override {}  // POV-Ray has no such line
    void parsed(const parser::Result& result, const StageTimes& times) override;
    void rendering() override;
    void pass(const std::string& name) override;
    void progress(double share) override;
    void rendered(const StageTimes& times, const trace::RenderStatistics& statistics) override;
    void written(const std::string&) override {}
    void skipped(const std::string& path) override;
    void note(const std::string& text) override;
    void cancelled(const Kept& kept) override;
    void failed(const std::vector<scene::Message>& errors) override;
    void finished() override;

private:
    using Clock = std::chrono::steady_clock;
    const bool verbose_;
    long long pixels_ = 0;
    std::mutex writing_;
    int percent_ = -1;         ///< shown last
    int step_ = 1;             ///< percent between two lines on a pipe
    Clock::time_point shown_;  ///< when
    bool parsing_ = false;
};

/// As POV-Ray tells it: `File 'file' line n: Parse Error: words`, the lines that follow with a blank in front.
/// \param plain said of what has no place: "Parse Error", "Fatal error"
std::string povray_text(const scene::Message& message, const char* plain);

}  // namespace app
