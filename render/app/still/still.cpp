#include "render/app/still/still.h"

#include "render/app/run/stage_options.h"
#include "render/app/still/samples.h"
#include "render/picture/passes/passes.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>

namespace app {
namespace {

using StillClock = std::chrono::steady_clock;

constexpr int kCoarse[] = {16, 8, 4};
constexpr auto kShowEvery = std::chrono::milliseconds(150);

/// What somebody sees of a picture that is not finished: coarse pixels, and over them the blocks that are.
class Looked {
public:
    explicit Looked(const StillTask& task) : task_(task), shown_{task.settings.width, task.settings.height, {}, 0}
    {
        shown_.hold(0, shown_.height);
    }

    /// False: cancelled.
    bool show_coarse()
    {
        const plan::Options whole = task_.scene.options;
        bool done = true;
        for (const int step : kCoarse) {
            task_.scene.options = coarse_options(whole, step);
            image::Image coarse;
            done = !trace::render(task_.scene, render_options(task_.settings, task_.cancel), coarse).cancelled;
            task_.scene.options = whole;
            if (!done) return false;
            for (int y = 0; y < shown_.height; ++y)
                for (int x = 0; x < shown_.width; ++x) std::copy_n(coarse.at(x / step, y / step), 4, shown_.at(x, y));
            show(shown_);
        }
        return true;
    }

    void show_block(const trace::Block& block, const image::Image& picture)
    {
        const std::lock_guard lock(mutex_);
        for (int y = block.top; y < block.top + block.height; ++y)
            std::copy_n(picture.at(block.left, y), 4 * block.width, shown_.at(block.left, y));
        const auto now = StillClock::now();
        if (now - last_ < kShowEvery) return;
        show(shown_);
    }

    void show(const image::Image& picture)
    {
        task_.preview(picture);
        last_ = StillClock::now();
    }

private:
    const StillTask& task_;
    std::mutex mutex_;
    image::Image shown_;
    StillClock::time_point last_;
};

trace::RenderStatistics sampled(const StillTask& task, std::shared_ptr<const trace::IndirectLight> light,
                                std::optional<Looked>& looked, double seconds_before, image::Image& picture)
{
    SampledTask samples{task.settings, task.scene, std::move(light), task.file.encoding};
    samples.seconds_before = seconds_before;
    samples.options = [&task] { return render_options(task.settings, task.cancel); };
    samples.note = task.note;
    if (looked) samples.after_pass = [&](double, bool) { looked->show(picture); };
    return draw_samples(samples, picture);
}

}  // namespace

trace::RenderOptions render_options(const Settings& settings, const std::atomic<bool>& cancel)
{
    trace::RenderOptions options;
    options.threads = threads_of(settings);
    options.isa = isa_of(settings);
    options.cancel = &cancel;
    return options;
}

plan::Options coarse_options(const plan::Options& whole, int step)
{
    plan::Options coarse = whole;
    coarse.antialiasing.method = 0;
    if (step == 1) return coarse;
    coarse.width = (whole.width + step - 1) / step;
    coarse.height = (whole.height + step - 1) / step;
    coarse.start_row = coarse.start_column = 0;
    coarse.end_row = coarse.end_column = -1;
    return coarse;
}

trace::RenderStatistics draw_still(const StillTask& task, image::Image& picture)
{
    const auto start = StillClock::now();
    picture = {task.settings.width, task.settings.height, {}, 0};
    picture.hold(0, picture.height);
    trace::RenderStatistics none;
    none.cancelled = true;
    std::optional<Looked> looked;
    if (task.preview) looked.emplace(task);
    if (looked && !task.settings.paths && !looked->show_coarse()) return none;
    trace::RenderOptions options = render_options(task.settings, task.cancel);
    const std::shared_ptr<const trace::IndirectLight> light = trace::run_passes(task.scene, options);
    if (task.cancel) return none;
    const std::chrono::duration<double> passed = StillClock::now() - start;
    if (task.settings.sampled()) return sampled(task, light, looked, task.seconds_before + passed.count(), picture);
    const trace::Blocks blocks(task.scene.options);
    options.indirect = light.get();
    if (looked) options.finished = [&](std::size_t i) { looked->show_block(blocks[i], picture); };
    return trace::render(task.scene, options, picture);
}

}  // namespace app
