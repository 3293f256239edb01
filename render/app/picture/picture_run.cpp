#include "render/app/picture/picture_making.h"

#include "render/app/run/stage_options.h"
#include "render/app/run/memory.h"
#include "render/app/still/still.h"
#include "render/app/output/output_name.h"
#include "render/app/parts/prepared_file.h"
#include "render/app/run/shell_commands.h"
#include "render/plan/sampling/path_scene.h"
#include "render/picture/cut.h"
#include "render/picture/passes/passes.h"
#include "render/picture/sampling/denoise.h"
#include "render/picture/sampling/sampled_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

namespace app {

namespace {

BlocksOf blocks_of(const PictureTask& task, const trace::Blocks& blocks)
{
    BlocksOf of;
    of.width = task.run.settings.width;
    of.height = task.run.settings.height;
    of.blocks = blocks;
    of.file = task.file;
    of.part = std::max(1, task.run.settings.shard);
    of.parts = std::max(1, task.run.settings.shards);
    return of;
}

}  // namespace

PictureRun::PictureRun(const PictureTask& task, StageTimes& times)
    : task_(task), settings_(task.run.settings), times_(times), blocks_(task.compiled.options),
      strip_(rows_of_blocks_in(picture_memory(settings_, picture_bytes(settings_)), blocks_, settings_.width,
                               settings_.height, task.file.type)),
      in_strips_(strip_ < blocks_.rows())
{
    const double samples =
        (trace::SampledPicture::kBytesPerPixel + (settings_.denoise ? trace::PathFeatures::kBytesPerPixel : 0.0)) *
        settings_.width * settings_.height;
    if (settings_.sampled() && (in_strips_ || !has_memory_for(settings_, samples)))
        throw TryAgain("not enough memory is free for the samples of so large a picture");
    if (in_strips_ && !task.layers.kinds.empty())
        throw TryAgain("not enough memory is free for the layers of so large a picture");
    if (in_strips_ && task.take) throw TryAgain("not enough memory is free for the views of so large a sheet");
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
    state_ = std::make_unique<StateFile>(beside.string(), blocks_of(task, blocks_), after);
}

void PictureRun::resume()
{
    if (!state_ || !settings_.continue_trace) return;
    const auto show = [this](const trace::Block& block, const float* samples) { partial_->show(block, samples); };
    switch (state_->resume(task_.run.cancel.requested, show)) {
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
        picture_.hold(0, settings_.height, part_ ? image::Pages::small : image::Pages::large);
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
    trace::RenderOptions options = app::render_options(settings_, task_.run.cancel.requested);
    options.progress = [this](double share) { task_.run.reporter.progress(share); };
    return options;
}

/// The passes before the picture. False: cancelled.
bool PictureRun::find_indirect_light()
{
    trace::RenderOptions options = render_options();
    if (settings_.radiosity_from_file) options.radiosity_from = settings_.radiosity_file;
    if (settings_.radiosity_to_file) options.radiosity_to = settings_.radiosity_file;
    options.prepared = prepared_ ? &*prepared_ : nullptr;
    options.pass = [this](std::string_view name) { task_.run.reporter.pass(std::string(name)); };
    indirect_ = trace::run_passes(task_.compiled, options);
    if (indirect_) task_.run.reporter.pass("picture");
    times_.finish("trace");
    return !cancelled();
}

/// What --prepare has left, if it is of this picture.
void PictureRun::find_prepared()
{
    if (settings_.shards == 0 && !(settings_.prepare && settings_.continue_trace)) return;
    bool other = false;
    const std::string path = prepared_path(settings_, task_.path);
    prepared_ = read_prepared(path, task_.file.fingerprint, other);
    if (other && settings_.shards > 0)
        task_.run.reporter.note(path + " is of another picture or damaged: the part does without");
}

/// Empty: cancelled.
std::vector<double> PictureRun::coarse_costs()
{
    trace::RenderOptions options = render_options();
    options.progress = {};
    options.indirect = indirect_.get();
    return trace::coarse_costs(task_.compiled, options);
}

/// Leaves what the parts need of the whole. Returns the exit status.
int PictureRun::prepare()
{
    std::vector<double> costs = coarse_costs();
    if (costs.empty()) return give_up();
    const std::string path = prepared_path(settings_, task_.path);
    write_prepared(path, task_.file.fingerprint, {indirect_.get(), std::move(costs)});
    task_.run.reporter.note("prepared: " + path);
    task_.run.reporter.rendered(times_, statistics_);
    return kSuccess;
}

/// The part that --shard asks for. False: cancelled.
bool PictureRun::choose_blocks()
{
    if (settings_.shards == 0) return true;
    const auto own = static_cast<std::uint32_t>(settings_.shard - 1);
    std::vector<std::uint32_t> owners(blocks_.size());
    if (settings_.decides_by_whole()) {
        task_.run.reporter.note(
            "--error, --samples=N% and --denoise look at the whole picture: part 1 is all of it, and "
            "the others are empty");
    } else {
        const std::vector<double> costs = prepared_ ? prepared_->costs : coarse_costs();
        if (costs.empty()) return false;
        owners = trace::deal_by_cost(blocks_, costs, settings_.shards);
    }
    if (settings_.time > 0.0)
        task_.run.reporter.note("--time gives each part its seconds: the picture is not that of one run");
    BlocksOf of = blocks_of(task_, blocks_);
    for (std::uint32_t i = 0; i < owners.size(); ++i) {
        others_.push_back(owners[i] != own);
        if (owners[i] == own) of.wanted.push_back(i);
    }
    image::Channels layers = layers::layers_of(task_.layers.kinds, task_.layers.names);
    of.layers = std::move(layers.names);
    of.attributes = std::move(layers.attributes);
    part_ = std::make_unique<PicturePart>(task_.path, std::move(of));
    return true;
}

/// False: cancelled.
bool PictureRun::trace(std::size_t first, std::size_t last)
{
    trace::RenderOptions options = render_options();
    options.indirect = indirect_.get();
    options.first = first * blocks_.per_row();
    options.last = last * blocks_.per_row();
    options.others = others_;
    const auto all = static_cast<double>(blocks_.size()),
               away = static_cast<double>(std::count(others_.begin(), others_.end(), true));
    options.progress = [this, all, away](double share) {
        task_.run.reporter.progress((share * all - away) / (all - away));
    };
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

/// Rows above `end`, as far as they are not in the file. False: cancelled.
bool PictureRun::write_rows(int end)
{
    if (task_.take) task_.take(picture_);
    if (!settings_.output_to_file || task_.take) return true;
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

/// False: cancelled.
bool PictureRun::finish_part()
{
    if (!task_.layers.kinds.empty()) {
        const auto layers = make_layers(task_.run, task_.layers, task_.compiled, render_options(),
                                        {part_->of().first_layer_row(), part_->of().last_layer_row()});
        if (!layers) return false;
        part_->put(*layers);
    }
    part_->finish();
    return true;
}

void PictureRun::put_in_place()
{
    if (!writer_ && !part_) return;
    if (writer_) writer_->finish();
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
    part_.reset();
    save();
    return kCancelled;
}

/// Strip by strip. False: cancelled.
bool PictureRun::trace_blocks()
{
    for (std::size_t first = 0; first < blocks_.rows(); first += strip_) {
        const std::size_t last = std::min(first + strip_, blocks_.rows());
        prepare_strip(first, last);
        if (!(settings_.sampled() ? trace_samples() : trace(first, last))) return false;
        if (growing_) growing_->stop();
        const trace::Block lowest = blocks_[last * blocks_.per_row() - 1];
        if (part_) part_->put(first * blocks_.per_row(), last * blocks_.per_row(), picture_);
        else if (!write_rows(last == blocks_.rows() ? settings_.height : lowest.top + lowest.height)) return false;
        if (!in_strips_) continue;
        if (partial_) partial_->show(picture_);
        if (state_) state_->keep(picture_);  // before its rows leave the memory
    }
    return true;
}

int PictureRun::render()
{
    resume();
    task_.last_resort.replace([this] {
        save();
        if (writer_) std::remove(writer_->growing().c_str());
        if (part_) std::remove(part_->growing().c_str());
    });
    task_.run.reporter.rendering();
    if (settings_.paths && !plan::has_light(task_.compiled))
        task_.run.reporter.note("nothing in the scene gives light: no light source, no sky or background, no finish "
                                "with emission; the picture is black");
    find_prepared();
    if (settings_.prepare && prepared_) {
        task_.run.reporter.skipped(prepared_path(settings_, task_.path));
        return kSuccess;
    }
    if (!find_indirect_light()) return give_up();
    if (settings_.prepare) return prepare();
    if (!choose_blocks() || !trace_blocks() || cancelled()) return give_up();
    tell_far();
    if (part_) {
        if (!finish_part()) return give_up();
    } else if (!task_.layers.kinds.empty() && !write_layers(task_.run, task_.layers, task_.compiled, picture_,
                                                            task_.file, task_.path, render_options())) {
        return give_up();
    }
    put_in_place();
    if (indirect_ && indirect_->failed_save) throw scene::Error(*indirect_->failed_save);
    task_.run.reporter.rendered(times_, statistics_);
    return kSuccess;
}

int render_picture(const PictureTask& task, StageTimes& times)
{
    const auto picture = std::make_unique<PictureRun>(task, times);
    const int status = picture->render();
    task.last_resort.replace([] {});
    return status;
}

}  // namespace app
