#pragma once

#include "render/app/report/console_reporter.h"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace app {

/// Records a run for --json while it hands everything on to the reporter that speaks to the user.
class Journal final : public ConsoleReporter {
public:
    Journal(Streams& streams, ConsoleReporter& speaker, const Settings& settings)
        : ConsoleReporter(streams), speaker_(speaker), settings_(settings)
    {}

    void begin(const FrameFacts& facts) override;
    void message(const scene::Message& message) override;
    void parsed(const parser::Result& result, const StageTimes& times) override;
    void made_from(const std::string& fingerprint) override;
    void still_reading(const parser::ReadingPlace& where, double seconds) override
    {
        speaker_.still_reading(where, seconds);
    }
    void rendering() override { speaker_.rendering(); }
    void pass(const std::string& name) override;
    void progress(double share) override { speaker_.progress(share); }
    void rendered(const StageTimes& times, const trace::RenderStatistics& statistics) override;
    void written(const std::string& path) override;
    void skipped(const std::string& path) override;
    void note(const std::string& text) override;
    void cancelled(const Kept& kept) override;
    void failed(const std::vector<scene::Message>& errors) override;
    void finished() override;

    /// An error that nobody needs to be told of.
    void record_error(const std::string& text) { errors_ = {{scene::Severity::Error, text, {}, {}, {}, {}}}; }

    /// The record as JSON (docs/command_line.md has its fields).
    /// \param status  exit status
    std::string text(int status) const;

private:
    /// Of a frame, before the picture: photons, radiosity. Its time is a part of that of tracing.
    struct Pass {
        std::string name;
        double seconds, processor_seconds;  ///< till the next began; before that, when it began
    };
    struct Picture {
        std::string path, fingerprint;
    };
    struct FrameRecord {
        int number = 0;
        double clock = 0.0;
        bool skipped = false, written = false;
        std::string scene, picture, fingerprint;
        std::vector<Picture> pictures;  ///< more than one of --views
        Kept kept;
        parser::Statistics parser;
        std::vector<std::string> files;
        std::size_t objects = 0;
        std::vector<scene::Message> messages;
        std::vector<StageTimes::Stage> phases;
        std::vector<Pass> passes;
        std::optional<trace::RenderStatistics> statistics;
    };
    void put_frame(class JsonWriter& json, const FrameRecord& frame) const;

    using Clock = std::chrono::steady_clock;
    ConsoleReporter& speaker_;
    const Settings& settings_;
    const Clock::time_point start_ = Clock::now();
    std::vector<FrameRecord> frames_;
    std::vector<scene::Message> notes_, errors_;
    bool cancelled_ = false;
};

}  // namespace app
