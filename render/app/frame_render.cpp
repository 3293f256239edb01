#include "render/app/frame_render.h"

#include "parser/parse.h"
#include "render/app/output_name.h"
#include "render/app/picture_identity.h"
#include "render/app/preview_file.h"
#include "render/app/scene_file.h"
#include "render/app/scene_queries.h"
#include "render/app/shell_commands.h"
#include "render/app/stage_options.h"
#include "render/app/state_file.h"
#include "render/app/text.h"
#include "render/plan/compiled_scene.h"

#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace app {

namespace {

void tell_message(void* narrator, const parser::Message& message) { static_cast<Narrator*>(narrator)->message(message); }

/// Through a file of its own: picture libraries want to seek.
void write_to_stream(std::FILE* stream, const image::Files& files, const image::Image& picture, const image::FileSettings& file)
{
    std::string folder = (std::filesystem::temp_directory_path() / "whittle-XXXXXX").string();
    if (!mkdtemp(folder.data())) throw image::FileError("cannot make a folder in '" + std::filesystem::temp_directory_path().string() + "'");
    const std::string path = folder + "/picture" + image::extension(file.type);
    try {
        files.write(path, picture, file);
        std::ifstream in(path, std::ios::binary);
        char block[65536];
        while (in.read(block, sizeof block) || in.gcount() > 0) std::fwrite(block, 1, static_cast<std::size_t>(in.gcount()), stream);
    } catch (...) {
        std::filesystem::remove_all(folder);
        throw;
    }
    std::filesystem::remove_all(folder);
    if (std::fflush(stream) != 0 || std::ferror(stream)) throw image::FileError("cannot write to standard output");
}

/// The files that a picture is made of, in the order in which they were read.
void print_dependencies(const Settings& settings, const parser::Result& parsed)
{
    for (const std::vector<std::string>* files : {&settings.ini_files, &parsed.scene.files, &parsed.data_files})
        for (const std::string& file : *files) fmt::print("{}\n", file);
}

/// Prints what --dump and --explain ask for. True if that was all.
bool print_stage(const Settings& settings, const scene::Description& description)
{
    using Dump = Settings::Dump;
    if (settings.dump == Dump::Scene) fmt::print("{}", scene::dump(description));
    if (settings.dump != Dump::Plan && !settings.explain) return settings.dump == Dump::Scene || settings.parse_only;
    const plan::CompiledScene compiled = plan::compile(description, plan_options(settings));
    if (settings.dump == Dump::Plan) fmt::print("{}", plan::dump(compiled));
    if (settings.explain) fmt::print(stderr, "{}", plan::explain(compiled, description.files));
    return settings.dump == Dump::Plan || settings.parse_only;
}

trace::RenderOptions render_options(const Settings& settings, Narrator& narrator, const std::atomic<bool>& cancel)
{
    trace::RenderOptions options;
    options.threads = settings.threads;
    options.progress = [&narrator](double share) { narrator.progress(share); };
    options.cancel = &cancel;
    options.isa = isa_of(settings);
    return options;
}

bool already_rendered(const Settings& settings, const std::string& path)
{
    std::error_code error;
    return settings.continue_trace && settings.output_to_file && std::filesystem::file_size(path, error) > 0 && !error;
}

/// Null where no file is written.
std::unique_ptr<StateFile> state_file(const Run& run, const std::string& path, const parser::Options& options, const parser::Result& parsed, const plan::Options& planned)
{
    if (path.empty() || !run.settings.output_to_file) return nullptr;
    std::filesystem::path beside(path);
    beside.replace_extension(".whittle-state");
    return std::make_unique<StateFile>(beside.string(), [&] { return picture_identity(options, planned, parsed); }, trace::blocks_of(planned), run.settings.state_after);
}

/// Null where none is asked for.
std::unique_ptr<PreviewFile> preview_file(const Settings& settings, const scene::Description& description)
{
    if (settings.preview_file.empty()) return nullptr;
    return std::make_unique<PreviewFile>(settings.preview_file, settings.width, settings.height, file_settings(settings, description).encoding);
}

void resume(Run& run, StateFile& state, image::Image& picture)
{
    switch (state.resume(run.settings.width, run.settings.height, picture)) {
        case StateFile::Found::Nothing: return;
        case StateFile::Found::Blocks: return run.narrator.note(fmt::format("{} of {} blocks taken from {}", state.resumed(), state.done().size(), state.path()));
        case StateFile::Found::OtherPicture: return run.narrator.note(fmt::format("{} is of another picture or of other options: rendered from the start", state.path()));
    }
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
    if (!fs::is_directory(folder, error)) throw OptionError(fmt::format("cannot write '{}': there is no folder '{}' (--make-folders makes it)", path, folder.string()));
    if (access(folder.c_str(), W_OK) != 0) throw OptionError(fmt::format("cannot write '{}': {}", path, std::strerror(errno)));
}

parser::Result parse_scene(Run& run, const Frame& frame, const std::string& path, parser::Options& options, SceneQueries& queries)
{
    const Settings& settings = run.settings;
    options = parser_options(settings, run.list, frame);
    options.queries = &queries;
    options.cancel = &run.cancel.requested;
    if (!path.empty()) options.write_folders.push_back(std::filesystem::absolute(path).parent_path().string());
    const std::string scene = run.input ? "stdin" : find_scene(settings);
    run.narrator.begin({settings, run.list, frame, scene, settings.output_to_file ? path : "", window_of(settings)});
    try {
        return run.input ? parser::parse_text(*run.input, scene, options, tell_message, &run.narrator)
                         : parser::parse_file(scene, options, tell_message, &run.narrator);
    } catch (const parser::Cancelled&) {
        throw AbortedRun();
    }
}

/// While it lives, the run looks by itself whether it is wanted.
struct Heeding {
    explicit Heeding(Cancellation& cancel) : flag(cancel.heeded) { flag = true; }
    Heeding(const Heeding&) = delete;
    Heeding& operator=(const Heeding&) = delete;
    ~Heeding() { flag = false; }
    std::atomic<bool>& flag;
};

void refuse_warnings(const parser::Result& parsed)
{
    const auto count = std::count_if(parsed.messages.begin(), parsed.messages.end(), [](const parser::Message& m) { return m.severity == parser::Severity::Warning; });
    if (count > 0) throw std::runtime_error(fmt::format("{} warning{}, and --werror makes {} an error", count, count == 1 ? "" : "s", count == 1 ? "it" : "them"));
}

/// The picture goes where it belongs, and what was kept for +C is no longer needed.
void write_picture(Run& run, const std::string& path, const image::Image& picture, const scene::Description& description, StageTimes& times, StateFile* state)
{
    const image::FileSettings file = file_settings(run.settings, description);
    if (path.empty()) write_to_stream(to_standard_error(run.settings) ? stderr : stdout, run.files, picture, file);
    else run.files.write(path, picture, file);
    times.finish("write");
    if (!path.empty()) run.narrator.written(path);
    if (state) state->remove();
}

}  // namespace

bool from_standard_input(const Settings& settings) { return settings.input_file == "-" || same_text(settings.input_file, "stdin"); }

trace::Isa isa_of(const Settings& settings)
{
    if (settings.isa == "v2") return trace::Isa::V2;
    if (settings.isa == "v3") return trace::Isa::V3;
    if (settings.isa == "v4") return trace::Isa::V4;
    return trace::Isa::Auto;
}

int render_frame(Run& run, const Frame& frame)
{
    const Settings& settings = run.settings;
    const std::string path = output_path(settings, run.list, frame);
    check_folder(settings, path);
    if (!path.empty()) run.streams.open_files(settings, std::filesystem::path(path).parent_path().string());
    if (already_rendered(settings, path)) {
        run.narrator.skipped(path);
        return kSuccess;
    }
    StageTimes times;
    SceneQueries queries(settings.threads);
    parser::Options options;
    const Heeding heeding(run.cancel);  // until the picture file is in place
    const parser::Result parsed = parse_scene(run, frame, path, options, queries);
    times.finish("parse");
    run.narrator.parsed(parsed, times.stages().back().second);
    if (settings.warnings_are_errors) refuse_warnings(parsed);
    if (settings.deps) print_dependencies(settings, parsed);
    if (print_stage(settings, parsed.scene)) return kSuccess;

    const plan::CompiledScene compiled = plan::compile(parsed.scene, plan_options(settings));
    times.finish("plan");
    image::Image picture;
    const std::unique_ptr<StateFile> state = state_file(run, path, options, parsed, compiled.options);
    if (state && settings.continue_trace) resume(run, *state, picture);
    run.narrator.rendering();
    trace::RenderOptions render = render_options(settings, run.narrator, run.cancel.requested);
    const std::unique_ptr<PreviewFile> preview = preview_file(settings, parsed.scene);
    const std::vector<trace::Block> blocks = preview ? trace::blocks_of(compiled.options) : std::vector<trace::Block>();
    if (state) render.done = state->done();
    for (std::size_t i = 0; preview && i < render.done.size(); ++i)
        if (render.done[i]) preview->show(blocks[i], picture);
    render.finished = [&](std::size_t block) {
        if (state) state->finished(block, picture);
        if (preview) preview->show(blocks[block], picture);
    };
    const trace::RenderStatistics statistics = trace::render(compiled, render, picture);
    times.finish("trace");
    if (statistics.cancelled) {
        run.narrator.cancelled(state && state->keep(picture) ? state->path() : "");
        return kCancelled;
    }
    if (settings.output_to_file) write_picture(run, path, picture, parsed.scene, times, state.get());
    run.narrator.rendered(times, statistics);
    return kSuccess;
}

}  // namespace app
