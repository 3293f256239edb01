#include "render/app/picture/views_render.h"

#include "render/app/output/output_name.h"
#include "render/app/output/streamed_file.h"
#include "render/app/run/memory.h"
#include "render/app/run/shell_commands.h"
#include "render/app/views/views.h"
#include "render/plan/turn_camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

namespace app {
namespace {

/// Speaks of all views as of one picture: its progress is theirs, and what was traced is told when the last is done.
class ViewTeller final : public ConsoleReporter {
public:
    ViewTeller(Streams& streams, ConsoleReporter& speaker, std::size_t count)
        : ConsoleReporter(streams), speaker_(speaker), count_(static_cast<double>(count))
    {}
    void begin(const FrameFacts& facts) override { speaker_.begin(facts); }
    void message(const scene::Message& message) override { speaker_.message(message); }
    void still_reading(const parser::ReadingPlace& where, double seconds) override
    {
        speaker_.still_reading(where, seconds);
    }
    void parsed(const parser::Result& result, const StageTimes& times) override { speaker_.parsed(result, times); }
    void made_from(const std::string& fingerprint) override { speaker_.made_from(fingerprint); }
    void rendering() override
    {
        if (done_ == 0.0) speaker_.rendering();
        in_picture_ = true;
    }
    void pass(const std::string& name) override { in_picture_ = name == "picture"; }
    void progress(double share) override
    {
        if (in_picture_) speaker_.progress((done_ + share) / count_);
    }
    void rendered(const StageTimes&, const trace::RenderStatistics& statistics) override { all_ += statistics; }
    void written(const std::string& path) override { speaker_.written(path); }
    void skipped(const std::string& path) override { speaker_.skipped(path); }
    void note(const std::string& text) override { speaker_.note(text); }
    void cancelled(const Kept& kept) override { speaker_.cancelled(kept); }
    void failed(const std::vector<scene::Message>& errors) override { speaker_.failed(errors); }
    void finished() override { speaker_.finished(); }

    void view_done() { done_ += 1.0; }
    const trace::RenderStatistics& all() const { return all_; }

private:
    ConsoleReporter& speaker_;
    const double count_;
    double done_ = 0.0;
    bool in_picture_ = true;
    trace::RenderStatistics all_;
};

/// The picture of all views, in memory.
class Sheet {
public:
    Sheet(const SheetForm& form, const Settings& settings)
        : form_(form), width_(settings.width), height_(settings.height)
    {
        const double bytes = kTracedPixelBytes * width_ * height_ * form.columns * form.rows;
        if (!has_memory_for(settings, bytes))
            throw OptionError(fmt::format("a sheet of {}x{} views takes {:.0f} MB of memory, more than there is for it "
                                          "(--memory)",
                                          form.columns, form.rows, bytes / 1e6));
        picture_.width = width_ * form.columns;
        picture_.height = height_ * form.rows;
        picture_.hold(0, picture_.height);
    }
    void put(std::size_t number, const image::Image& view)
    {
        const int column = static_cast<int>(number) % form_.columns, row = static_cast<int>(number) / form_.columns;
        const int left = column * width_, top = (form_.from_below ? form_.rows - 1 - row : row) * height_;
        for (int y = 0; y < height_; ++y)
            std::copy_n(view.at(0, y), 4 * static_cast<std::size_t>(width_), picture_.at(left, top + y));
    }
    const image::Image& picture() const { return picture_; }

private:
    const SheetForm form_;
    const int width_, height_;
    image::Image picture_;
};

class ViewsRun {
public:
    ViewsRun(const ViewsTask& task, const SceneViews& views)
        : task_(task), settings_(task.run.settings), views_(views),
          teller_(task.run.streams, task.run.reporter, views.views.size()), run_{settings_,        task.run.list,
                                                                                 task.run.files,   task.run.streams,
                                                                                 teller_,          task.run.cancel,
                                                                                 task.run.remains, {},
                                                                                 task.run.told_far}
    {
        for (const SceneView& view : views.views) cameras_.push_back(camera_of(view, settings_, task.description));
    }

    int render(StageTimes& times)
    {
        const int status = views_.sheet ? render_sheet(times) : render_each();
        task_.run.told_far = run_.told_far;
        times.finish(views_.sheet ? "write" : "trace");
        if (status == kSuccess && rendered_) task_.run.reporter.rendered(times, teller_.all());
        return status;
    }

private:
    int render_one(std::size_t i, const image::FileSettings& file, const std::string& path,
                   const std::function<void(const image::Image&)>& take)
    {
        if (task_.run.cancel.requested) throw AbortedRun();
        plan::turn_camera(task_.compiled, cameras_[i]);
        const auto moment = [&](int k) {
            auto scene = task_.moment(k);
            plan::turn_camera(*scene, cameras_[i]);
            return scene;
        };
        StageTimes of_view;  // --time counts the seconds of each
        const int status = render_picture(
            {run_, task_.last_resort, task_.compiled, file, path, moment, task_.moments, task_.layers, take}, of_view);
        teller_.view_done();
        rendered_ = true;
        return status;
    }

    int render_each()
    {
        if (task_.path.empty() && cameras_.size() > 1)
            throw OptionError(
                "pictures of many views need names: --views without a sheet does not go to standard output");
        for (std::size_t i = 0; i < cameras_.size(); ++i) {
            const std::string path = view_path(task_.path, views_.views[i]);
            const image::FileSettings file = task_.file(views_.views[i].text);
            if (task_.done(path, file.fingerprint)) {
                teller_.view_done();
                continue;
            }
            if (const int status = render_one(i, file, path, {}); status != kSuccess) return status;
        }
        return kSuccess;
    }

    int render_sheet(StageTimes& times)
    {
        if (!task_.layers.kinds.empty())
            throw OptionError("--aov does not go with a sheet of views: a view each has layers");
        std::string cameras =
            fmt::format("sheet {} {} {}\n", views_.sheet->columns, views_.sheet->rows, views_.sheet->from_below);
        for (const SceneView& view : views_.views) cameras += view.text;
        const image::FileSettings file = task_.file(cameras);
        std::string path = task_.path;
        if (!path.empty() && settings_.output_file.empty()) path.insert(path.rfind('.'), views_.sheet->ending);
        if (task_.done(path, file.fingerprint)) return kSuccess;
        Sheet sheet(*views_.sheet, settings_);
        for (std::size_t i = 0; i < cameras_.size(); ++i) {
            const auto take = [&](const image::Image& view) { sheet.put(i, view); };
            if (const int status = render_one(i, file, {}, take); status != kSuccess) return status;
        }
        times.finish("trace");
        if (!settings_.output_to_file) return kSuccess;
        if (path.empty()) {
            StreamedFile out(file.type);
            run_.files.write(out.path(), sheet.picture(), file);
            out.send(to_standard_error(settings_) ? stderr : stdout);
        } else {
            run_.files.write(path, sheet.picture(), file);
        }
        task_.run.reporter.note(fmt::format("a sheet of {}x{} views, {}x{}", views_.sheet->columns, views_.sheet->rows,
                                            sheet.picture().width, sheet.picture().height));
        if (!path.empty()) task_.run.reporter.written(path);
        return kSuccess;
    }

    const ViewsTask& task_;
    const Settings& settings_;
    const SceneViews& views_;
    std::vector<scene::Camera> cameras_;
    ViewTeller teller_;
    Run run_;
    bool rendered_ = false;
};

}  // namespace

int render_views(const ViewsTask& task, StageTimes& times)
{
    const SceneViews views = views_of(task.run.settings, task.description.camera, task.compiled);
    return ViewsRun(task, views).render(times);
}

void print_views(const ViewsTask& task)
{
    for (const SceneView& view : views_of(task.run.settings, task.description.camera, task.compiled).views)
        fmt::print("// {}\n{}", view.name, view.text);
}

}  // namespace app
