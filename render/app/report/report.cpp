#include "render/app/report/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>

namespace app {

namespace {}  // namespace

double processor_seconds()
{
    timespec now{};  // POSIX's clock, finer than std::clock()
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

StageTimes::StageTimes() : last_processor_(processor_seconds()) {}

void StageTimes::finish(const char* stage)
{
    const Clock::time_point now = Clock::now();
    const double processor = processor_seconds(), seconds = std::chrono::duration<double>(now - last_).count();
    const auto known =
        std::find_if(stages_.begin(), stages_.end(), [&](const Stage& s) { return std::strcmp(s.name, stage) == 0; });
    // A picture in strips is traced and written in turn.
    Stage& of = known != stages_.end() ? *known : stages_.emplace_back(Stage{stage, 0.0, 0.0});
    of.seconds += seconds;
    of.processor_seconds += processor - last_processor_;
    last_ = now;
    last_processor_ = processor;
}

std::string report_text(const StageTimes& times, const trace::RenderStatistics& statistics)
{
    std::string text = "time ";
    for (const StageTimes::Stage& stage : times.stages())
        text += fmt::format("  {} {:.3f} s", stage.name, stage.seconds);
    const trace::RayCounts& rays = statistics.rays;
    text += fmt::format("\nrays   camera {}  shadow {}  reflected {}  refracted {}", rays.camera, rays.shadow,
                        rays.reflected, rays.refracted);
    if (rays.supersamples) text += fmt::format("  (supersamples {})", rays.supersamples);
    if (statistics.samples && std::isnan(statistics.error))
        text += fmt::format("\nerror  not known: a pixel has one sample or none of {}", statistics.samples);
    else if (statistics.samples)
        text += fmt::format("\nerror  {:.3f} of 255 expected from the spread of {} samples", statistics.error,
                            statistics.samples);
    const double total = static_cast<double>(rays.camera + rays.shadow + rays.reflected + rays.refracted);
    const double rate = statistics.seconds_trace > 0.0 ? total / statistics.seconds_trace / 1e6 : 0.0;
    return text + fmt::format("\nspeed  {:.2f} million rays per second, {} thread{}, {}\n", rate, statistics.threads,
                              statistics.threads == 1 ? "" : "s", statistics.isa);
}

}  // namespace app
