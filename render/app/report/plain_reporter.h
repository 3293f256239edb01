#pragma once

#include "render/app/report/console_reporter.h"
#include "render/app/report/progress.h"

#include <optional>

namespace app {

/// Whittle's own few lines: messages in the form `file:line:column: error: text`, one line for the picture, the report.
class PlainReporter final : public ConsoleReporter {
public:
    PlainReporter(Streams& streams, bool progress) : ConsoleReporter(streams), with_bar_(progress) {}

    void begin(const FrameFacts& facts) override;
    void message(const scene::Message& message) override;
    void still_reading(const parser::ReadingPlace& where, double seconds) override;
    void parsed(const parser::Result&, const StageTimes&) override { bar_.reset(); }
    void rendering() override { bar_.emplace(with_bar_); }
    void pass(const std::string& name) override { bar_.emplace(with_bar_, name); }
    void progress(double share) override { bar_->show(share); }
    void rendered(const StageTimes& times, const trace::RenderStatistics& statistics) override;
    void written(const std::string& path) override;
    void skipped(const std::string& path) override;
    void note(const std::string& text) override;
    void cancelled(const Kept& kept) override;
    void failed(const std::vector<scene::Message>& errors) override;
    void finished() override {}

private:
    const bool with_bar_;
    std::optional<Progress> bar_;
    int width_ = 0, height_ = 0;
};

}  // namespace app
