#include "render/app/picture/picture_making.h"

#include "render/app/run/stage_options.h"
#include "render/picture/passes/passes.h"
#include "render/picture/sampling/denoise.h"
#include "render/picture/sampling/sampled_render.h"

#include <fmt/format.h>

#include <algorithm>

namespace app {

/// A picture of many samples, pass after pass, moment after moment. False: cancelled.
bool PictureRun::trace_samples()
{
    trace::SamplingGoal goal;
    constexpr int kUsualPaths = 64;
    const bool usual = settings_.paths && !settings_.asks_for_samples();
    goal.samples = static_cast<std::uint32_t>(usual ? kUsualPaths : settings_.samples);
    if (task_.moments > 1) goal.samples = std::max(1u, goal.samples / static_cast<std::uint32_t>(task_.moments));
    goal.seed = settings_.seed;
    goal.even = settings_.samples_error > 0.0;
    goal.error = goal.even ? settings_.samples_error : settings_.error;
    double before = 0.0;
    for (const StageTimes::Stage& stage : times_.stages()) before += stage.seconds;
    if (settings_.time > 0.0) {
        constexpr double kWriting = 8e-8;  // seconds a pixel, as a PNG takes
        const double writing = settings_.output_to_file ? kWriting * settings_.width * settings_.height : 0.0;
        if (before > settings_.time)
            task_.run.reporter.note(
                fmt::format("what comes before the picture (reading, photons, radiosity) took {:.2f} s, "
                            "more than --time gives",
                            before));
        goal.seconds = std::max(settings_.time - before - writing, 1e-3);
    }
    const image::Transcoder shown(task_.file.encoding.curves.working, task_.file.encoding.curves.file);
    const auto level = [&shown](double light) {
        return 255.0 * std::clamp(static_cast<double>(shown.to_file(static_cast<float>(light))), 0.0, 1.0);
    };
    trace::SampledPicture samples(settings_.width, settings_.height);
    std::optional<trace::PathFeatures> features;
    if (settings_.denoise) features.emplace(settings_.width, settings_.height);
    const auto after_pass = [&](double share) {
        samples.show(picture_);
        samples.fill(picture_, task_.compiled.options);
        for (std::size_t i = 0; preview_ && i < blocks_.size(); ++i) preview_->show(blocks_[i], picture_);
        if (growing_) growing_->show(picture_);
        any_done_ = true;
        if (!goal.samples) task_.run.reporter.progress(share);
    };
    for (int k = 0; k < task_.moments && !statistics_.cancelled; ++k) {
        trace::RenderOptions options = render_options();
        options.others = others_;
        if (task_.moments > 1)
            options.progress = [&](double share) { task_.run.reporter.progress((k + share) / task_.moments); };
        const auto later = k > 0 ? task_.moment(k) : nullptr;
        const plan::CompiledScene& scene = later ? *later : task_.compiled;
        const auto light = later ? trace::run_passes(scene, options) : indirect_;
        options.indirect = light.get();
        if (cancelled()) return false;
        statistics_ +=
            trace::render_sampled(scene, options, goal, level, samples, after_pass, features ? &*features : nullptr);
    }
    if (statistics_.broken > 0)
        task_.run.reporter.note(
            fmt::format("{} of {} samples are no numbers, as a function of a pigment or a normal may "
                        "give: they count as black",
                        statistics_.broken, statistics_.samples));
    if (features) {
        trace::denoise(samples, *features, picture_);
        samples.fill(picture_, task_.compiled.options);
    }
    times_.finish("trace");
    return !statistics_.cancelled;
}

}  // namespace app
