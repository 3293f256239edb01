#include "render/study/study.h"

#include "render/image/compare/flip.h"
#include "render/kernel/gather/indirect_light.h"
#include "render/picture/passes/passes.h"
#include "render/picture/sampling/denoise.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace study {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

}  // namespace

Error error_of(const Shown& truth, const Shown& picture, const image::TransferCurve& curve)
{
    constexpr double kBeyond = 3.0;
    Error out;
    const std::size_t pixels = truth.values.size() / 3;
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        double worst = 0.0;
        for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
            const double a = static_cast<double>(truth.values[c]), b = static_cast<double>(picture.values[c]);
            const double light = static_cast<double>(curve.decode(truth.values[c])) -
                                 static_cast<double>(curve.decode(picture.values[c]));
            out.levels += (a - b) * (a - b);
            out.linear += light * light;
            worst = std::max(worst, std::abs(a - b));
        }
        if (255.0 * worst > kBeyond) ++beyond;
    }
    const double values = 3.0 * static_cast<double>(pixels);
    out.levels = 255.0 * std::sqrt(out.levels / values);
    out.linear = std::sqrt(out.linear / values);
    out.beyond = static_cast<double>(beyond) / static_cast<double>(pixels);
    out.flip = image::mean_flip(truth.values, picture.values, truth.width, truth.height);
    return out;
}

Study::Study(const scene::Description& scene, const plan::Options& options, const trace::RenderOptions& render,
             const image::OutputCurves& curves)
    : scene_(scene), options_(options), paths_(options.paths), render_(render), curves_(curves),
      transcoder_(curves.working, curves.file)
{
    options_.antialiasing.method = 0;
    if (paths_) options_.paths = options_.free_sampling = false;
    const Trial trial{scene_, options_, {}, {}, false};
    const plan::CompiledScene compiled = plan::compile(trial.scene, trial.options);
    settings_ = ladder(scene_, compiled, this->render(trial).statistics.rays, paths_);
}

trace::ShownLevel Study::level() const
{
    return [this](double light) {
        return 255.0 * std::clamp(static_cast<double>(transcoder_.to_file(static_cast<float>(light))), 0.0, 1.0);
    };
}

Study::Rendered Study::render(const Trial& trial) const
{
    plan::CompiledScene compiled = plan::compile(trial.scene, trial.options);
    if (trial.compiled) trial.compiled(compiled);
    Rendered out{};
    const Clock::time_point start = Clock::now();
    trace::RenderOptions render = render_;
    const std::shared_ptr<const trace::IndirectLight> indirect = trace::run_passes(compiled, render);
    render.indirect = indirect.get();
    image::Image picture;
    if (trial.sampled()) {
        trace::SampledPicture samples(options_.width, options_.height);
        std::optional<trace::PathFeatures> features;
        if (trial.denoise) features.emplace(options_.width, options_.height);
        trace::PathFeatures* const seen = features ? &*features : nullptr;
        trace::SamplingGoal goal = trial.goal;
        if (goal.seconds > 0.0) goal.seconds = std::max(goal.seconds - since(start), 1e-3);
        out.statistics = trace::render_sampled(compiled, render, goal, level(), samples, {}, seen);
        if (features) trace::denoise(samples, *features, render.threads, picture);
        else samples.show(picture);
        samples.fill(picture, compiled.options);
    } else {
        out.statistics = trace::render(compiled, render, picture);
    }
    out.seconds = since(start);
    out.picture.width = options_.width;
    out.picture.height = options_.height;
    out.picture.values.reserve(3 * static_cast<std::size_t>(options_.width) *
                               static_cast<std::size_t>(options_.height));
    for (int y = 0; y < options_.height; ++y)
        for (int x = 0; x < options_.width; ++x)
            for (int c = 0; c < 3; ++c)
                out.picture.values.push_back(std::clamp(transcoder_.to_file(picture.at(x, y)[c]), 0.0f, 1.0f));
    return out;
}

const Truth& Study::find_truth(double error, double seconds)
{
    Trial trial{scene_, options_, {}, {}, false};
    make_truth(trial, error, seconds, paths_);
    Rendered found = render(trial);
    truth_.picture = std::move(found.picture);
    truth_.expected_error = found.statistics.error;
    truth_.samples = static_cast<double>(found.statistics.samples) /
                     (options_.width * static_cast<double>(options_.height));
    truth_.seconds = found.seconds;
    return truth_;
}

std::optional<Result> Study::run(const Setting& setting) const
{
    constexpr double kEnough = 0.2;
    constexpr int kMostRuns = 5;
    Trial trial{scene_, options_, {}, {}, false};
    setting.apply(trial);
    Result out;
    out.family = setting.family;
    out.name = setting.name;
    out.asked_error = setting.asked_error;
    out.asked_seconds = setting.asked_seconds;
    out.seconds = std::numeric_limits<double>::infinity();
    double all = 0.0;
    for (int i = 0; i < kMostRuns && all < kEnough; ++i) {
        Rendered found = render(trial);
        if (found.statistics.cancelled || (render_.cancel != nullptr && *render_.cancel)) return {};
        out.seconds = std::min(out.seconds, found.seconds);
        all += found.seconds;
        const trace::RayCounts& rays = found.statistics.rays;
        out.rays = rays.camera + rays.shadow + rays.reflected + rays.refracted;
        out.picture = std::move(found.picture);
    }
    out.error = error(out.picture);
    return out;
}

std::vector<const Result*> pareto_front(const std::vector<Result>& results, bool povray)
{
    std::vector<const Result*> sorted;
    for (const Result& result : results)
        if (result.povray == povray) sorted.push_back(&result);
    std::sort(sorted.begin(), sorted.end(), [](const Result* a, const Result* b) {
        return a->seconds != b->seconds ? a->seconds < b->seconds : a->error.levels < b->error.levels;
    });
    std::vector<const Result*> out;
    for (const Result* result : sorted)
        if (out.empty() || result->error.levels < out.back()->error.levels) out.push_back(result);
    return out;
}

const Result* cheapest(const std::vector<Result>& results, double levels, bool povray)
{
    for (const Result* result : pareto_front(results, povray))
        if (result->error.levels <= levels) return result;
    return nullptr;
}

}  // namespace study
