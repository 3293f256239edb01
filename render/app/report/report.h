#pragma once

#include "render/picture/render.h"

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace app {

/// Of the process so far, all of its threads.
double processor_seconds();

/// Time per stage, in the order in which they ran.
class StageTimes {
public:
    struct Stage {
        const char* name;
        double seconds;            ///< by the clock on the wall
        double processor_seconds;  ///< of all threads
    };
    StageTimes();
    /// What has passed since the last call (or the construction) goes to `stage`.
    void finish(const char* stage);
    const std::vector<Stage>& stages() const { return stages_; }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
    double last_processor_;
    std::vector<Stage> stages_;
};

/// The last lines of a run: times, rays by kind, rays per second.
std::string report_text(const StageTimes& times, const trace::RenderStatistics& statistics);

}  // namespace app
