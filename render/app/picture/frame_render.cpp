#include "render/app/picture/frame_render.h"

#include "parser/parse.h"
#include "render/app/embed/collect.h"
#include "render/app/output/fingerprint.h"
#include "render/app/output/output_name.h"
#include "render/app/parts/block_file.h"
#include "render/app/layers/cost_report.h"
#include "render/app/run/exit_status.h"
#include "render/app/run/last_resort.h"
#include "render/app/run/memory.h"
#include "render/app/picture/picture_run.h"
#include "render/app/picture/views_render.h"
#include "render/app/run/scene_file.h"
#include "render/app/run/scene_queries.h"
#include "render/app/run/shell_commands.h"
#include "render/app/run/stage_options.h"
#include "render/app/base/text.h"
#include "render/image/fingerprint_reader.h"
#include "render/plan/compiled_scene.h"
#include "render/plan/geometry/function_check.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace app {

namespace {

void tell_message(void* reporter, const parser::Message& message)
{
    static_cast<ConsoleReporter*>(reporter)->message(message);
}

/// The files that a picture is made of, in the order in which they were read.
void print_dependencies(const Settings& settings, const parser::Result& parsed)
{
    for (const std::vector<std::string>* files : {&settings.ini_files, &parsed.scene.files, &parsed.data_files})
        for (const std::string& file : *files) fmt::print("{}\n", file);
}

/// Prints what --dump and --explain ask for. True if that was all.
bool print_stage(Run& run, const parser::Result& parsed)
{
    using Dump = Settings::Dump;
    const Settings& settings = run.settings;
    const scene::Description& description = parsed.scene;
    if (settings.explain)
        for (const parser::ReadingCost& cost : parsed.statistics.costs)
            fmt::print(stderr, "reading: {:.3f} s in {} {}, {:.3f} s of it its own{}\n", cost.seconds, cost.what,
                       cost.name, cost.own_seconds, cost.what == "file" ? "" : " (" + cost.place + ")");
    if (settings.dump == Dump::Scene) fmt::print("{}", scene::dump(description));
    if (settings.dump != Dump::Plan && !settings.explain && settings.heat_file.empty())
        return settings.dump == Dump::Scene || settings.parse_only;
    const plan::CompiledScene compiled = plan::compile(description, plan_options(settings), threads_of(settings));
    if (settings.dump == Dump::Plan) fmt::print("{}", plan::dump(compiled));
    if (settings.explain) fmt::print(stderr, "{}", plan::explain(compiled));
    report_cost(run, description, compiled);
    return settings.dump == Dump::Plan || settings.parse_only;
}

/// Whether +C finds a picture there, be it of this scene or of another.
bool picture_there(const Settings& settings, const std::string& path)
{
    std::error_code error;
    const auto state = std::filesystem::path(path).replace_extension(".whittle-state");
    if (settings.partial > 0.0 && std::filesystem::exists(state, error)) return false;  // it is not whole
    return settings.continue_trace && settings.output_to_file && std::filesystem::file_size(path, error) > 0 && !error;
}

/// Opens nothing yet: a picture that cannot be put in place is an error before the scene is read.
void check_folder(const Settings& settings, const std::string& path)
{
    namespace fs = std::filesystem;
    if (path.empty() || !settings.output_to_file || settings.parse_only) return;
    fs::path folder = fs::path(path).parent_path();
    if (folder.empty()) folder = ".";
    std::error_code error;
    if (settings.make_folders) fs::create_directories(folder, error);
    if (!fs::is_directory(folder, error))
        throw OptionError(
            fmt::format("cannot write '{}': there is no folder '{}' (--make-folders makes it)", path, folder.string()));
    if (access(folder.c_str(), W_OK) != 0)
        throw OptionError(fmt::format("cannot write '{}': {}", path, std::strerror(errno)));
}

parser::Result parse_scene(Run& run, const Frame& frame, const std::string& path, parser::Options& options,
                           SceneQueries& queries)
{
    const Settings& settings = run.settings;
    options = parser_options(settings, run.list, frame);
    options.queries = &queries;
    options.cancel = &run.cancel.requested;
    options.still_reading = [&run](const parser::ReadingPlace& where, double seconds) {
        run.reporter.still_reading(where, seconds);
    };
    if (!path.empty()) options.write_folders.push_back(std::filesystem::absolute(path).parent_path().string());
    const std::string scene = run.input ? "stdin" : find_scene(settings);
    run.reporter.begin({settings, run.list, frame, scene, settings.output_to_file ? path : "", window_of(settings)});
    try {
        return run.input ? parser::parse_text(*run.input, scene, options, tell_message, &run.reporter)
                         : parser::parse_file(scene, options, tell_message, &run.reporter);
    } catch (const parser::Cancelled&) {
        throw AbortedRun();
    }
}

int moments(const Settings& settings) { return settings.shutter > 0.0 ? settings.motion_samples : 1; }

/// The frame at moment k of its exposure, which begins with it.
Frame at_moment(const Run& run, const Frame& frame, int k)
{
    if (!(run.settings.shutter > 0.0)) return frame;
    const double interval = run.list.animation && run.list.clock_delta != 0.0 ? run.list.clock_delta : 1.0;
    Frame out = frame;
    out.clock += static_cast<float>((k + 0.5) / run.settings.motion_samples * run.settings.shutter * interval);
    return out;
}

/// A scene at a later moment: whatever it has to tell was told at the first.
/// \param text_hash  of its text then
std::unique_ptr<plan::CompiledScene> compiled_at(Run& run, const Frame& frame, const std::string& path,
                                                 std::uint64_t text_hash)
{
    const Settings& settings = run.settings;
    parser::Options options = parser_options(settings, run.list, frame);
    SceneQueries queries(threads_of(settings), run.cancel.requested, isa_of(settings));
    options.queries = &queries;
    options.cancel = &run.cancel.requested;
    if (!path.empty()) options.write_folders.push_back(std::filesystem::absolute(path).parent_path().string());
    try {
        parser::Result parsed = run.input ? parser::parse_text(*run.input, "stdin", options)
                                          : parser::parse_file(find_scene(settings), options);
        if (parsed.text_hashes.front() != text_hash)
            throw TryAgain(fmt::format("{} was edited between two moments of one picture", parsed.scene.files.front()));
        return std::make_unique<plan::CompiledScene>(
            plan::compile(std::move(parsed.scene), plan_options(settings), threads_of(settings)));
    } catch (const parser::Cancelled&) {
        throw AbortedRun();
    }
}

/// How the picture is written, and what it is made from.
/// \param views  as text, empty where the scene's own camera makes it
image::FileSettings fingerprinted(Run& run, const parser::Options& reading, const parser::Result& parsed,
                                  const std::shared_ptr<const std::string>& carried, const std::string& views)
{
    image::FileSettings file = file_settings(run.settings, parsed.scene);
    file.carried = carried;
    const plan::Options planned = plan_options(run.settings);
    file.fingerprint = fingerprint_text(fingerprint_of({run.settings, reading, planned, file, parsed, views}));
    run.reporter.made_from(file.fingerprint);
    return file;
}

/// Whether +C leaves the picture that is there.
/// \param made_from  of that picture; nothing: there is none that tells
bool is_done(Run& run, const std::string& path, const std::optional<std::string>& made_from,
             const std::string& fingerprint)
{
    if (made_from == fingerprint) {
        run.reporter.skipped(path);
        return true;
    }
    if (made_from)
        run.reporter.note(fmt::format("{} is of an older scene, of other options or of another version: it is rendered "
                                      "anew",
                                      path));
    return false;
}

void refuse_warnings(const parser::Result& parsed)
{
    const auto count = std::count_if(parsed.messages.begin(), parsed.messages.end(),
                                     [](const parser::Message& m) { return m.severity == parser::Severity::Warning; });
    if (count > 0)
        throw std::runtime_error(fmt::format("{} warning{}, and --werror makes {} an error", count,
                                             count == 1 ? "" : "s", count == 1 ? "it" : "them"));
}

}  // namespace

int render_frame(Run& run, const Frame& frame)
{
    const Settings& settings = run.settings;
    const std::string path = output_path(settings, run.list, frame);
    check_folder(settings, path);
    if (!settings.parse_only && settings.dump == Settings::Dump::None) check_fits(settings, path);
    if (!path.empty()) run.streams.open_files(settings, std::filesystem::path(path).parent_path().string());
    const bool there = settings.views.empty() && picture_there(settings, path);
    const std::optional<std::string> made_from = !there                ? std::nullopt
                                                 : settings.shards > 0 ? whole_part(path)
                                                                       : image::fingerprint_in(path);
    if (there && !made_from && settings.shards == 0) {  // nothing tells what it is of
        run.reporter.skipped(path);
        return kSuccess;
    }
    StageTimes times;
    SceneQueries queries(threads_of(settings), run.cancel.requested, isa_of(settings));
    parser::Options options;
    LastResort last_resort(run.cancel, [&run] { run.reporter.cancelled({}); });  // until the picture file is in place
    parser::Result parsed = parse_scene(run, at_moment(run, frame, 0), path, options, queries);
    times.finish("parse");
    run.reporter.parsed(parsed, times);
    if (settings.warnings_are_errors) refuse_warnings(parsed);
    if (settings.deps) print_dependencies(settings, parsed);
    const bool last = &frame == &run.list.frames.back();
    if (print_stage(run, parsed)) {
        if (last) run.remains.leave(std::move(parsed));
        return kSuccess;
    }

    const auto carried = carried_of(run, frame, options, parsed);
    const auto file_of = [&](const std::string& cameras) {
        return fingerprinted(run, options, parsed, carried, cameras);
    };
    std::optional<image::FileSettings> file;
    if (settings.views.empty()) {
        file.emplace(file_of({}));
        if (is_done(run, path, made_from, file->fingerprint)) return kSuccess;
    }
    const LayersTask layers = layers_task(run, parsed.scene, path);
    for (const std::string& missing : plan::functions_without_number(parsed.scene)) run.reporter.note(missing);
    plan::CompiledScene compiled = plan::compile(std::move(parsed.scene), plan_options(settings), threads_of(settings));
    times.finish("plan");
    const auto moment = [&](int k) {
        return compiled_at(run, at_moment(run, frame, k), path, parsed.text_hashes.front());
    };
    if (file)
        return render_picture({run, last_resort, compiled, *file, path, moment, moments(settings), layers}, times);
    const auto done = [&](const std::string& view, const std::string& fingerprint) {
        if (!picture_there(settings, view)) return false;
        const std::optional<std::string> of_view = image::fingerprint_in(view);
        return is_done(run, view, of_view ? of_view : fingerprint,
                       fingerprint);  // of one that tells nothing it is left
    };
    const ViewsTask views{run,    last_resort,       parsed.scene, compiled, path,
                          moment, moments(settings), layers,       file_of,  done};
    if (settings.dump != Settings::Dump::Views) return render_views(views, times);
    print_views(views);
    return kSuccess;
}

}  // namespace app
