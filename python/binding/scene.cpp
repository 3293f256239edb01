#include "python/binding/scene.h"

#include "render/app/options/command_line.h"
#include "render/app/options/ini_file.h"
#include "render/app/output/fingerprint.h"
#include "render/app/run/stage_options.h"
#include "render/app/run/scene_file.h"
#include "render/app/run/scene_reading.h"
#include "render/app/still/still.h"
#include "render/layers/layers.h"
#include "render/layers/object_names.h"
#include "render/plan/geometry/function_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <initializer_list>

namespace python {

namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kName = "text";  // of a scene that is no file, in messages

}  // namespace

app::Settings settings_of(const Words& words)
{
    app::Settings settings;
    app::read_default_ini_file(settings);
    app::apply_command_line(settings, words.options);
    for (const std::string& word : words.exact) app::apply_word(settings, word);
    return settings;
}

std::string Source::text_of(const std::string& file) const
{
    return text_ && file == kName ? *text_ : app::text_on_disk(file).value_or("");
}

Source::Looks Source::looks_of(const parser::Options& o)
{
    Looks looks;
    for (const auto* folders : {&o.library_path, &o.write_folders})
        for (const std::string& folder : *folders) looks.always += folder + "\n";
    for (const auto& [name, value] : o.declared_numbers) looks.always += fmt::format("{}={}\n", name, value);
    for (const auto& [name, value] : o.declared_strings) looks.always += fmt::format("{}=\"{}\"\n", name, value);
    looks.always += fmt::format("{} {} {} {} {}\n", o.version, o.version_given,
                                o.povray ? static_cast<int>(*o.povray) : -1, o.include_header, o.restrict_read);
    looks.size = fmt::format("{} {}", o.image_width, o.image_height);
    looks.clock = fmt::format("{} {} {} {} {} {} {} {}", o.clock, o.clock_on, o.frame_number, o.initial_frame,
                              o.final_frame, o.clock_delta, o.initial_clock, o.final_clock);
    return looks;
}

/// In the scene's own text or in a file that it includes; words in comments count too.
bool Source::mentions(std::initializer_list<std::string_view> words) const
{
    const auto in = [&](const std::string& text) {
        return std::any_of(words.begin(), words.end(),
                           [&](std::string_view word) { return text.find(word) != std::string::npos; });
    };
    return (text_ && in(*text_)) ||
           std::any_of(read_->scene.files.begin(), read_->scene.files.end(),
                       [&](const std::string& file) { return in(app::text_on_disk(file).value_or("")); });
}

bool Source::still_right(const Looks& looks) const
{
    return read_ && looks.always == looks_.always && (looks.size == looks_.size || !looks_at_size_) &&
           (looks.clock == looks_.clock || !looks_at_clock_);
}

Source::Read Source::read(const app::Settings& settings, const std::atomic<bool>& cancel)
{
    const std::lock_guard lock(mutex_);
    const app::SceneReading reading(settings, cancel);
    Looks looks = looks_of(reading.options);
    if (still_right(looks)) return read_;
    read_ =
        std::make_shared<const parser::Result>(text_ ? parser::parse_text(*text_, kName, reading.options)
                                                     : parser::parse_file(app::find_scene(settings), reading.options));
    looks_ = std::move(looks);
    // A camera has the picture's shape by itself in 3.8.
    looks_at_size_ = read_->scene.povray == scene::PovRay::V38 || mentions({"image_width", "image_height"});
    looks_at_clock_ = mentions({"clock", "frame"});
    return read_;
}

namespace {

scene::Camera camera_of(const std::string& text, const app::Settings& settings, const scene::Description& of,
                        const std::atomic<bool>& cancel)
{
    app::SceneReading reading(settings, cancel);
    if (!reading.options.povray) reading.options.povray = of.povray;
    const scene::Description alone = parser::parse_text(text, "camera", reading.options).scene;
    if (text.find("camera") == std::string::npos || !alone.objects.empty())
        throw app::OptionError("a camera is a block camera { ... } and nothing else");
    return alone.camera;
}

std::vector<layers::Kind> kinds_of(const std::string& names)
{
    if (names.empty()) return {};
    try {
        return layers::kinds_of(names);
    } catch (const std::runtime_error& error) {
        throw app::OptionError(error.what());
    }
}

/// One picture on its way.
class Render {
public:
    Render(Source& source, const Request& request, Job& job)
        : source_(source), request_(request), job_(job), settings_(settings_of(request.words)),
          kinds_(kinds_of(request.layers))
    {}

    std::shared_ptr<Picture> picture()
    {
        const auto start = Clock::now();
        app::refuse_contradictions(settings_);
        if (settings_.shutter > 0.0) throw app::OptionError("Shutter is for the command line alone");
        const Source::Read read = source_.read(settings_, job_.cancel);
        auto out = std::make_shared<Picture>();
        out->messages = read->messages;
        out->settings = settings_;
        out->facts = file_facts(read->scene);
        out->file = file_of(*read);
        const auto note = [&](const std::string& text) {
            out->messages.push_back({scene::Severity::Note, text, {}, {}, {}, {}});
        };
        for (const std::string& told : settings_.notes) note(told);
        for (const std::string& missing : plan::functions_without_number(read->scene)) note(missing);
        plan::CompiledScene compiled = planned(read->scene);
        const std::chrono::duration<double> before = Clock::now() - start;
        app::StillTask task{settings_, compiled, out->file, before.count(), job_.cancel, note};
        if (request_.preview)
            task.preview = [&](const image::Image& so_far) {
                auto shown = std::make_shared<Picture>();
                shown->image = so_far;
                shown->settings = settings_;
                shown->file = out->file;
                shown->file.quick = true;
                job_.show([shown, look = request_.preview] { look(shown); });
            };
        const trace::RenderStatistics statistics = app::draw_still(task, out->image);
        if (statistics.cancelled) throw parser::Cancelled();
        if (!kinds_.empty()) add_layers(*out, *read, compiled);
        out->seconds = statistics.seconds_trace;
        out->isa = statistics.isa;
        return out;
    }

private:
    image::FileSettings file_of(const parser::Result& read) const
    {
        image::FileSettings file = app::file_settings(settings_, read.scene);
        const app::SceneReading reading(settings_, job_.cancel);
        if (!request_.camera)
            file.fingerprint = app::fingerprint_text(
                app::fingerprint_of({settings_, reading.options, app::plan_options(settings_), file, read, {}}));
        return file;
    }

    plan::CompiledScene planned(const scene::Description& description) const
    {
        const plan::Options options = app::plan_options(settings_);
        const int threads = app::threads_of(settings_);
        if (!request_.camera) return plan::compile(description, options, threads);
        scene::Description other = description;
        other.camera = camera_of(*request_.camera, settings_, description, job_.cancel);
        return plan::compile(std::as_const(other), options, threads);
    }

    void add_layers(Picture& out, const parser::Result& read, const plan::CompiledScene& compiled) const
    {
        const std::vector<std::string> names =
            layers::object_names(read.scene, [this](const std::string& file) { return source_.text_of(file); });
        const bool many = compiled.options.antialiasing.method != 0 || settings_.sampled();
        out.layers = layers::make_layers(compiled, kinds_, names, app::render_options(settings_, job_.cancel), many,
                                         {0, settings_.height});
        if (!out.layers) throw parser::Cancelled();
    }

    Source& source_;
    const Request& request_;
    Job& job_;
    const app::Settings settings_;
    const std::vector<layers::Kind> kinds_;
};

}  // namespace

std::shared_ptr<Picture> render(const std::shared_ptr<Source>& source, Request request)
{
    return result_of<std::shared_ptr<Picture>>(
        [source, request = std::move(request)](Job& job) { return Render(*source, request, job).picture(); });
}

}  // namespace python
