#include "render/app/render_command.h"

#include "parser/parse.h"
#include "render/app/frames.h"
#include "render/app/library_path.h"
#include "render/app/narrator.h"
#include "render/app/output_name.h"
#include "render/app/report.h"
#include "render/app/scene_file.h"
#include "render/app/scene_queries.h"
#include "render/app/window.h"
#include "render/image/files.h"
#include "render/plan/compiled_scene.h"
#include "render/trace/render.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

namespace app {

namespace {

void tell_message(void* narrator, const parser::Message& message) { static_cast<Narrator*>(narrator)->message(message); }

parser::Options parser_options(const Settings& settings, const FrameList& list, const Frame& frame)
{
    parser::Options options;
    options.library_path = settings.library_path;
    for (std::string& folder : default_library_path()) options.library_path.push_back(std::move(folder));
    options.declared_numbers = settings.declared_numbers;
    options.declared_strings = settings.declared_strings;
    options.version_given = settings.version.has_value();
    options.version = settings.version.value_or(options.version);
    options.image_width = settings.width;
    options.image_height = settings.height;
    options.clock = static_cast<double>(frame.clock);
    options.clock_on = list.clock_on;
    options.frame_number = frame.number;
    options.initial_frame = list.initial_frame;
    options.final_frame = list.final_frame;
    options.clock_delta = list.clock_delta;
    if (list.animation) {
        options.initial_clock = static_cast<double>(settings.initial_clock);
        options.final_clock = static_cast<double>(settings.final_clock);
    }
    options.include_header = settings.include_header;
    return options;
}

plan::Options plan_options(const Settings& settings)
{
    plan::Options options;
    options.width = settings.width;
    options.height = settings.height;
    options.quality = settings.quality;
    options.alpha = settings.alpha && image::stores_alpha(settings.file_type);
    plan::Antialiasing& aa = options.antialiasing;
    aa.method = settings.antialias ? settings.sampling_method : 0;
    aa.threshold = static_cast<double>(settings.antialias_threshold);
    aa.depth = settings.antialias_depth;
    aa.jitter = settings.jitter ? static_cast<double>(settings.jitter_amount) : 0.0;
    aa.gamma = static_cast<double>(settings.antialias_gamma);
    const Window window = window_of(settings);
    options.start_row = window.first_row;
    options.end_row = window.last_row;
    options.start_column = window.first_column;
    options.end_column = window.last_column;
    options.block_size = settings.block_size;
    if (settings.split_unions) options.split_unions = *settings.split_unions;
    return options;
}

image::FileSettings file_settings(const Settings& settings, const scene::Description& description)
{
    std::optional<image::TransferCurve> assumed;
    using Kind = scene::AssumedGamma::Kind;
    const scene::AssumedGamma& gamma = description.global.assumed_gamma;
    if (gamma.kind == Kind::Srgb) assumed = image::TransferCurve::srgb();
    if (gamma.kind == Kind::Power) assumed = image::TransferCurve::power(static_cast<float>(gamma.exponent));
    // An option Version=3.7 turns gamma handling on for the output of an older scene too (spec 2, 10.1).
    const int version = std::max(description.effective_version, settings.version.value_or(0));
    image::FileSettings file;
    file.type = settings.file_type;
    file.encoding.curves = image::output_curves(assumed, version, settings.file_gamma, settings.display_gamma);
    file.encoding.bits = settings.greyscale && file.type == image::FileType::Png ? 16 : settings.bits_per_color;
    file.encoding.alpha = settings.alpha;
    file.encoding.greyscale = settings.greyscale;
    if (settings.compression > 1) file.jpeg_quality = settings.compression;
    return file;
}

/// Through a file of its own: picture libraries want to seek.
void write_to_standard_output(const image::Files& files, const image::Image& picture, const image::FileSettings& file)
{
    const std::string path = (std::filesystem::temp_directory_path() / fmt::format("whittle-{}{}", getpid(), image::extension(file.type))).string();
    files.write(path, picture, file);
    std::ifstream in(path, std::ios::binary);
    char block[65536];
    while (in.read(block, sizeof block) || in.gcount() > 0) std::fwrite(block, 1, static_cast<std::size_t>(in.gcount()), stdout);
    std::filesystem::remove(path);
    if (std::fflush(stdout) != 0 || std::ferror(stdout)) throw image::FileError("cannot write to standard output");
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

trace::Isa isa_of(const Settings& settings)
{
    if (settings.isa == "v2") return trace::Isa::V2;
    if (settings.isa == "v3") return trace::Isa::V3;
    if (settings.isa == "v4") return trace::Isa::V4;
    return trace::Isa::Auto;
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

/// What the frames of a run share.
struct Run {
    const Settings& settings;
    const FrameList list;
    const image::Files files;
    Streams& streams;
    Narrator& narrator;
    Cancellation& cancel;
};

int render_frame(Run& run, const Frame& frame)
{
    const Settings& settings = run.settings;
    const std::string path = output_path(settings, run.list, frame);
    if (!path.empty()) run.streams.open_files(settings, std::filesystem::path(path).parent_path().string());
    if (already_rendered(settings, path)) {
        run.narrator.skipped(path);
        return kSuccess;
    }
    StageTimes times;
    SceneQueries queries;
    parser::Options options = parser_options(settings, run.list, frame);
    options.queries = &queries;
    if (!path.empty()) options.write_folders.push_back(std::filesystem::absolute(path).parent_path().string());
    const std::string scene = find_scene(settings);
    run.narrator.begin({settings, run.list, frame, scene, settings.output_to_file ? path : "", window_of(settings)});
    const parser::Result parsed = parser::parse_file(scene, options, tell_message, &run.narrator);
    times.finish("parse");
    run.narrator.parsed(parsed, times.stages().back().second);
    if (print_stage(settings, parsed.scene)) return kSuccess;

    const plan::CompiledScene compiled = plan::compile(parsed.scene, plan_options(settings));
    times.finish("plan");
    image::Image picture;
    run.cancel.heeded = true;  // until the picture file is in place
    run.narrator.rendering();
    const trace::RenderStatistics statistics = trace::render(compiled, render_options(settings, run.narrator, run.cancel.requested), picture);
    times.finish("trace");
    if (statistics.cancelled) {
        run.narrator.cancelled("");
        return kCancelled;
    }
    if (settings.output_to_file) {
        const image::FileSettings file = file_settings(settings, parsed.scene);
        if (path.empty()) write_to_standard_output(run.files, picture, file);
        else run.files.write(path, picture, file);
        times.finish("write");
        if (!path.empty()) run.narrator.written(path);
    }
    run.cancel.heeded = false;
    run.narrator.rendered(times, statistics);
    return kSuccess;
}

int render_frames(Run& run)
{
    for (const Frame& frame : run.list.frames) {
        if (run.cancel.requested) {
            run.narrator.cancelled("");
            return kCancelled;
        }
        if (const int status = render_frame(run, frame); status != kSuccess) return status;
    }
    run.narrator.finished();
    return kSuccess;
}

}  // namespace

int render_command(const Settings& settings, Cancellation& cancel)
{
    if (settings.input_file.empty()) throw OptionError("no scene given: whittle scene.pov, or whittle --help");
    if (settings.dump == Settings::Dump::Tokens) {
        fmt::print("{}", parser::dump_tokens(find_scene(settings)));
        return kSuccess;
    }
    if (settings.greyscale && !image::stores_greyscale(settings.file_type)) throw OptionError("this output file type stores no greyscale: use +FN or +FP");
    window_of(settings);  // a window outside the picture is an error before the parse
    Streams streams(settings);
    const std::unique_ptr<Narrator> narrator = make_narrator(settings, streams);
    for (const std::string& note : settings.notes) narrator->note(note);
    if (!settings.not_acted_on.empty()) narrator->note(fmt::format("accepted without effect for now: {}", fmt::join(settings.not_acted_on, ", ")));
    Run run{settings, frames_of(settings), {}, streams, *narrator, cancel};
    try {
        const bool traces = !settings.parse_only && settings.dump == Settings::Dump::None;
        if (traces) trace::prepare(isa_of(settings), settings.threads);
        if (traces && settings.output_to_file) run.files.prepare(settings.file_type);
        return render_frames(run);
    } catch (const std::exception& error) {
        narrator->failed(error.what());
        return kError;
    }
}

}  // namespace app
