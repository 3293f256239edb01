#include "render/app/picture/picture_run.h"

#include "render/app/run/allocation.h"
#include "render/app/run/stage_options.h"
#include "render/app/run/memory.h"
#include "render/app/output/growing_picture.h"
#include "render/app/output/output_name.h"
#include "render/app/output/partial_picture.h"
#include "render/app/output/preview_file.h"
#include "render/app/output/scratch_folder.h"
#include "render/app/run/shell_commands.h"
#include "render/app/output/state_file.h"
#include "render/image/picture_writer.h"
#include "render/plan/sampling/path_scene.h"
#include "render/kernel/gather/indirect_light.h"
#include "render/picture/passes/passes.h"
#include "render/picture/sampling/denoise.h"
#include "render/picture/sampling/sampled_render.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>

namespace app {

namespace {

/// Standard output gets its picture through a file of its own: picture libraries want to seek.
class StreamedFile {
public:
    explicit StreamedFile(image::FileType type) : path_(folder_ / ("picture" + std::string(image::extension(type)))) {}
    const std::string& path() const { return path_; }
    void send(std::FILE* stream) const
    {
        std::ifstream in(path_, std::ios::binary);
        char block[65536];
        while (in.read(block, sizeof block) || in.gcount() > 0)
            std::fwrite(block, 1, static_cast<std::size_t>(in.gcount()), stream);
        if (std::fflush(stream) != 0 || std::ferror(stream)) throw image::FileError("cannot write to standard output");
    }

private:
    ScratchFolder folder_;
    std::string path_;
};

/// One picture being made.
class PictureRun {
public:
    PictureRun(const PictureTask& task, StageTimes& times);
    int render();

private:
    bool kept() const
    {
        return !task_.path.empty() && task_.run.settings.output_to_file;
    }  ///< a file that +C can go on with
    bool cancelled() const { return task_.run.cancel.requested; }
    void resume();
    void prepare_strip(std::size_t first, std::size_t last);
    trace::RenderOptions render_options();
    bool find_indirect_light();
    bool trace(std::size_t first, std::size_t last);
    bool trace_samples();
    bool write_rows(int end);
    void put_in_place();
    void tell_far();
    int give_up();
    void save();

    const PictureTask& task_;
    const Settings& settings_;
    StageTimes& times_;
    const trace::Blocks blocks_;
    const std::size_t strip_;  ///< rows of blocks that are in memory at a time
    const bool in_strips_;
    image::Image picture_;
    trace::RenderStatistics statistics_;
    std::shared_ptr<const trace::IndirectLight> indirect_;  ///< null: the scene has none
    std::unique_ptr<StateFile> state_;
    std::optional<PartialPicture> partial_;
    std::unique_ptr<PreviewFile> preview_;
    std::unique_ptr<GrowingPicture> growing_;
    std::atomic<bool> any_done_ = false;
    std::optional<StreamedFile> streamed_;
    std::unique_ptr<image::PictureWriter> writer_;
    std::vector<float> black_;  ///< a row outside of the window
};

PictureRun::PictureRun(const PictureTask& task, StageTimes& times)
    : task_(task), settings_(task.run.settings), times_(times), blocks_(task.compiled.options),
      strip_(rows_of_blocks_in(picture_memory(settings_), blocks_, settings_.width, settings_.height, task.file.type)),
      in_strips_(strip_ < blocks_.rows())
{
    const double samples =
        (trace::SampledPicture::kBytesPerPixel + (settings_.denoise ? trace::PathFeatures::kBytesPerPixel : 0.0)) *
        settings_.width * settings_.height;
    if (settings_.sampled() && (in_strips_ || samples > picture_memory(settings_)))
        throw TryAgain("not enough memory is free for the samples of so large a picture");
    if (in_strips_ && !task.layers.kinds.empty())
        throw TryAgain("not enough memory is free for the layers of so large a picture");
    if (strip_ == 0) throw TryAgain("not enough memory is left for the picture");  // it was when the run began
    picture_.width = settings_.width;
    picture_.height = settings_.height;
    if (!settings_.preview_file.empty())
        preview_ = std::make_unique<PreviewFile>(settings_.preview_file, settings_.width, settings_.height,
                                                 task.file.encoding);
    if (!kept()) return;
    if (settings_.partial > 0.0 && in_strips_)
        task.run.reporter.note("--partial needs the whole picture in memory: it is left out");
    else if (settings_.partial > 0.0)
        growing_ = std::make_unique<GrowingPicture>(task.run.files, task.path, settings_.width, settings_.height,
                                                    task.file, settings_.partial);
    partial_.emplace(task.run.files, task.path, settings_.width, settings_.height, task.file, in_strips_);
    if (in_strips_ && !has_room_for_state(settings_, task.path)) {
        task.run.reporter.note("there is no room beside the picture for what is finished of it: +C will not find any");
        return;
    }
    if (settings_.sampled()) return;  // all blocks are begun anew in each pass
    if (task.compiled.options.grain_stream)
        return;  // random numbers follow from those of the blocks before: none can be taken up
    std::filesystem::path beside(task.path);
    beside.replace_extension(".whittle-state");
    // A partial picture is never on disk without the state that +C continues from.
    const double after = growing_ ? std::min(settings_.state_after, settings_.partial) : settings_.state_after;
    state_ = std::make_unique<StateFile>(beside.string(), task.identity, blocks_, after);
}

void PictureRun::resume()
{
    if (!state_ || !settings_.continue_trace) return;
    const auto show = [this](const trace::Block& block, const float* samples) { partial_->show(block, samples); };
    switch (state_->resume(settings_.width, settings_.height, task_.run.cancel.requested, show)) {
    case StateFile::Found::Nothing: return;
    case StateFile::Found::Blocks:
        any_done_ = true;
        return task_.run.reporter.note(
            fmt::format("{} of {} blocks taken from {}", state_->resumed(), state_->done().size(), state_->path()));
    case StateFile::Found::OtherPicture:
        return task_.run.reporter.note(
            fmt::format("{} is of another picture or of other options: rendered from the start", state_->path()));
    case StateFile::Found::Cancelled: throw AbortedRun();
    }
}

/// Memory for the rows of blocks [first, last), and what is known of them.
void PictureRun::prepare_strip(std::size_t first, std::size_t last)
{
    if (in_strips_) {
        const trace::Block top = blocks_[first * blocks_.per_row()], bottom = blocks_[last * blocks_.per_row() - 1];
        picture_.hold(top.top, bottom.top + bottom.height - top.top);
    } else {
        picture_.hold(0, settings_.height);
    }
    const std::size_t begin = first * blocks_.per_row(), end = last * blocks_.per_row();
    if (state_) state_->load(begin, end, picture_);
    for (std::size_t i = begin; state_ && i < std::min(end, state_->done().size()); ++i) {
        if (!state_->done()[i]) continue;
        if (preview_) preview_->show(blocks_[i], picture_);
        if (growing_) growing_->show(blocks_[i], picture_);
    }
}

trace::RenderOptions PictureRun::render_options()
{
    trace::RenderOptions options;
    options.threads = threads_for(settings_.threads);
    options.isa = isa_of(settings_);
    options.cancel = &task_.run.cancel.requested;
    options.progress = [this](double share) { task_.run.reporter.progress(share); };
    return options;
}

/// The passes before the picture. False: cancelled.
bool PictureRun::find_indirect_light()
{
    trace::RenderOptions options = render_options();
    if (settings_.radiosity_from_file) options.radiosity_from = settings_.radiosity_file;
    if (settings_.radiosity_to_file) options.radiosity_to = settings_.radiosity_file;
    options.pass = [this](std::string_view name) { task_.run.reporter.pass(std::string(name)); };
    indirect_ = trace::run_passes(task_.compiled, options);
    if (indirect_) task_.run.reporter.pass("picture");
    times_.finish("trace");
    return !cancelled();
}

/// False: cancelled.
bool PictureRun::trace(std::size_t first, std::size_t last)
{
    trace::RenderOptions options = render_options();
    options.indirect = indirect_.get();
    options.first = first * blocks_.per_row();
    options.last = last * blocks_.per_row();
    if (state_) options.done = state_->done();
    options.finished = [this](std::size_t block) {
        if (state_) state_->finished(block, picture_);
        if (preview_) preview_->show(blocks_[block], picture_);
        if (growing_) growing_->show(blocks_[block], picture_);
        any_done_ = true;
    };
    statistics_ += trace::render(task_.compiled, options, picture_);
    times_.finish("trace");
    return !statistics_.cancelled;
}

/// The same of a picture of many samples, pass after pass, moment after moment. False: cancelled.
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

/// Rows above `end`, as far as they are not in the file. False: cancelled.
bool PictureRun::write_rows(int end)
{
    if (!settings_.output_to_file) return true;
    if (!writer_) {
        if (task_.path.empty()) streamed_.emplace(task_.file.type);
        writer_ = task_.run.files.start(streamed_ ? streamed_->path() : task_.path, settings_.width, settings_.height,
                                        task_.file);
        black_.assign(4 * static_cast<std::size_t>(settings_.width), 0.0f);
    }
    const int held = static_cast<int>(picture_.pixels.size() / black_.size());
    for (int i = writer_->taken(); i < end; ++i) {
        if (cancelled()) return false;
        const int row = writer_->next_row();
        writer_->put(row >= picture_.top && row < picture_.top + held ? picture_.at(0, row) : black_.data());
    }
    times_.finish("write");
    return true;
}

void PictureRun::put_in_place()
{
    if (!writer_) return;
    writer_->finish();
    if (streamed_) streamed_->send(to_standard_error(settings_) ? stderr : stdout);
    times_.finish("write");
    if (!task_.path.empty()) task_.run.reporter.written(task_.path);
    if (state_) state_->remove();
    if (partial_) partial_->remove();
}

/// Right rather than POV-Ray's, and said so: whoever compares looks for the cause.
void PictureRun::tell_far()
{
    if (statistics_.rays.far == 0 || task_.run.told_far) return;
    task_.run.told_far = true;
    task_.run.reporter.note(fmt::format(
        "{} rays met something farther than 1e7 units, which POV-Ray does not draw; --faithful leaves it out",
        statistics_.rays.far));
}

/// What is done goes where +C finds it, and where the user can look at it.
void PictureRun::save()
{
    Kept kept;
    if (state_ && state_->keep(picture_)) kept.state = state_->path();
    if (growing_) {
        growing_->stop();
        if (growing_->write()) kept.picture = task_.path;
    } else if (partial_ && any_done_) {
        kept.picture = partial_->write(picture_);
    }
    task_.run.reporter.cancelled(kept);
}

int PictureRun::give_up()
{
    task_.last_resort.noticed();
    writer_.reset();
    save();
    return kCancelled;
}

int PictureRun::render()
{
    resume();
    task_.last_resort.replace([this] {
        save();
        if (writer_) std::remove(writer_->growing().c_str());
    });
    task_.run.reporter.rendering();
    if (settings_.paths && !plan::has_light(task_.compiled))
        task_.run.reporter.note("nothing in the scene gives light: no light source, no sky or background, no finish "
                                "with emission; the picture is black");
    if (!find_indirect_light()) return give_up();
    for (std::size_t first = 0; first < blocks_.rows(); first += strip_) {
        const std::size_t last = std::min(first + strip_, blocks_.rows());
        prepare_strip(first, last);
        if (!(settings_.sampled() ? trace_samples() : trace(first, last))) return give_up();
        if (growing_) growing_->stop();
        const trace::Block lowest = blocks_[last * blocks_.per_row() - 1];
        if (!write_rows(last == blocks_.rows() ? settings_.height : lowest.top + lowest.height)) return give_up();
        if (!in_strips_) continue;
        if (partial_) partial_->show(picture_);
        if (state_) state_->keep(picture_);  // before its rows leave the memory
    }
    if (cancelled()) return give_up();
    tell_far();
    if (!task_.layers.kinds.empty() &&
        !write_layers(task_.run, task_.layers, task_.compiled, picture_, task_.file, task_.path, render_options()))
        return give_up();
    put_in_place();
    if (indirect_ && indirect_->failed_save) throw scene::Error(*indirect_->failed_save);
    task_.run.reporter.rendered(times_, statistics_);
    return kSuccess;
}

}  // namespace

int render_picture(const PictureTask& task, StageTimes& times)
{
    const auto picture = std::make_unique<PictureRun>(task, times);
    const int status = picture->render();
    task.last_resort.replace([] {});
    return status;
}

}  // namespace app
