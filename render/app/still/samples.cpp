#include "render/app/still/samples.h"

#include "render/picture/passes/passes.h"
#include "render/picture/sampling/denoise.h"
#include "render/picture/sampling/sampled_render.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace app {
namespace {

trace::SamplingGoal goal_of(const SampledTask& task)
{
    const Settings& settings = task.settings;
    trace::SamplingGoal goal;
    constexpr int kUsualPaths = 64;
    const bool usual = settings.paths && !settings.asks_for_samples();
    goal.samples = static_cast<std::uint32_t>(usual ? kUsualPaths : settings.samples);
    if (task.moments > 1) goal.samples = std::max(1u, goal.samples / static_cast<std::uint32_t>(task.moments));
    goal.seed = settings.seed;
    goal.even = settings.samples_error > 0.0;
    goal.error = goal.even ? settings.samples_error : settings.error;
    if (settings.time > 0.0) {
        constexpr double kWriting = 8e-8;  // seconds a pixel, as a PNG takes
        const double writing = settings.output_to_file ? kWriting * settings.width * settings.height : 0.0;
        if (task.seconds_before > settings.time)
            task.note(fmt::format("what comes before the picture (reading, photons, radiosity) took {:.2f} s, "
                                  "more than --time gives",
                                  task.seconds_before));
        goal.seconds = std::max(settings.time - task.seconds_before - writing, 1e-3);
    }
    return goal;
}

}  // namespace

trace::RenderStatistics draw_samples(const SampledTask& task, image::Image& picture)
{
    const trace::SamplingGoal goal = goal_of(task);
    const image::Transcoder shown(task.encoding.curves.working, task.encoding.curves.file);
    const auto level = [&shown](double light) {
        return 255.0 * std::clamp(static_cast<double>(shown.to_file(static_cast<float>(light))), 0.0, 1.0);
    };
    trace::RenderStatistics statistics;
    trace::SampledPicture samples(picture.width, picture.height);
    std::optional<trace::PathFeatures> features;
    if (task.settings.denoise) features.emplace(picture.width, picture.height);
    const auto after_pass = [&](double share) {
        samples.show(picture);
        samples.fill(picture, task.scene.options);
        if (task.after_pass) task.after_pass(share, goal.samples > 0);
    };
    for (int k = 0; k < task.moments && !statistics.cancelled; ++k) {
        trace::RenderOptions options = task.options();
        options.others = task.others;
        if (task.moments > 1 && task.progress)
            options.progress = [&](double share) { task.progress((k + share) / task.moments); };
        const auto later = k > 0 ? task.moment(k) : nullptr;
        const plan::CompiledScene& scene = later ? *later : task.scene;
        const auto light = later ? trace::run_passes(scene, options) : task.indirect;
        options.indirect = light.get();
        if (options.cancel != nullptr && *options.cancel) {
            statistics.cancelled = true;
            return statistics;
        }
        statistics +=
            trace::render_sampled(scene, options, goal, level, samples, after_pass, features ? &*features : nullptr);
    }
    if (statistics.broken > 0)
        task.note(fmt::format("{} of {} samples are no numbers, as a function of a pigment or a normal may "
                              "give: they count as black",
                              statistics.broken, statistics.samples));
    if (features) {
        trace::denoise(samples, *features, task.options().threads, picture);
        samples.fill(picture, task.scene.options);
    }
    return statistics;
}

}  // namespace app
