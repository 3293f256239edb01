#pragma once

#include "render/trace/render.h"

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace app {

/// Wall-clock time per stage, in the order in which they ran.
class StageTimes {
public:
    /// Seconds since the last call (or the construction) go to `stage`.
    void finish(const char* stage);
    const std::vector<std::pair<const char*, double>>& stages() const { return stages_; }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
    std::vector<std::pair<const char*, double>> stages_;
};

/// The last lines of a run: times, rays by kind, rays per second.
std::string report_text(const StageTimes& times, const trace::RenderStatistics& statistics);

}  // namespace app
