#include "render/app/report.h"

#include <fmt/format.h>

namespace app {

void StageTimes::finish(const char* stage)
{
    const Clock::time_point now = Clock::now();
    stages_.emplace_back(stage, std::chrono::duration<double>(now - last_).count());
    last_ = now;
}

std::string report_text(const StageTimes& times, const trace::RenderStatistics& statistics)
{
    std::string text = "time ";
    for (const auto& [stage, seconds] : times.stages()) text += fmt::format("  {} {:.3f} s", stage, seconds);
    const trace::RayCounts& rays = statistics.rays;
    text += fmt::format("\nrays   camera {}  shadow {}  reflected {}  refracted {}", rays.camera, rays.shadow, rays.reflected, rays.refracted);
    if (rays.supersamples) text += fmt::format("  (supersamples {})", rays.supersamples);
    const double total = static_cast<double>(rays.camera + rays.shadow + rays.reflected + rays.refracted);
    const double rate = statistics.seconds_trace > 0.0 ? total / statistics.seconds_trace / 1e6 : 0.0;
    return text + fmt::format("\nspeed  {:.2f} million rays per second, {} thread{}, {}\n", rate, statistics.threads,
                              statistics.threads == 1 ? "" : "s", statistics.isa);
}

}  // namespace app
