#include "render/app/picture/picture_making.h"

#include "render/app/still/samples.h"

namespace app {

/// False: cancelled.
bool PictureRun::trace_samples()
{
    SampledTask task{settings_, task_.compiled, indirect_, task_.file.encoding};
    for (const StageTimes::Stage& stage : times_.stages()) task.seconds_before += stage.seconds;
    task.moment = task_.moment;
    task.moments = task_.moments;
    task.options = [this] { return render_options(); };
    task.others = others_;
    task.note = [this](const std::string& text) { task_.run.reporter.note(text); };
    task.progress = [this](double share) { task_.run.reporter.progress(share); };
    task.after_pass = [this](double share, bool by_samples) {
        for (std::size_t i = 0; preview_ && i < blocks_.size(); ++i) preview_->show(blocks_[i], picture_);
        if (growing_) growing_->show(picture_);
        any_done_ = true;
        if (!by_samples) task_.run.reporter.progress(share);
    };
    statistics_ += draw_samples(task, picture_);
    times_.finish("trace");
    return !statistics_.cancelled;
}

}  // namespace app
