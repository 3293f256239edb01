#include "render/app/render_command.h"

#include "render/app/effective_ini.h"
#include "render/app/frame_render.h"
#include "render/app/journal.h"
#include "render/app/scene_file.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>

namespace app {

namespace {

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

/// Everything after the options are understood; errors are told.
int run_scene(const Settings& settings, Streams& streams, Narrator& narrator, Cancellation& cancel)
{
    try {
        for (const std::string& note : settings.notes) narrator.note(note);
        if (!settings.not_acted_on.empty()) narrator.note(fmt::format("accepted without effect for now: {}", fmt::join(settings.not_acted_on, ", ")));
        write_effective_ini(settings);
        Run run{settings, frames_of(settings), {}, streams, narrator, cancel, {}};
        if (from_standard_input(settings)) run.input = std::string(std::istreambuf_iterator<char>(std::cin), {});
        const bool traces = !settings.parse_only && settings.dump == Settings::Dump::None;
        if (traces) trace::prepare(isa_of(settings), settings.threads);
        if (traces && settings.output_to_file) run.files.prepare(settings.file_type);
        return render_frames(run);
    } catch (const std::exception& error) {
        narrator.failed(error.what());
        return kError;
    }
}

void write_journal(const std::string& path, const std::string& text)
{
    if (path == "-") {
        fmt::print("{}", text);
        return;
    }
    std::ofstream out(path, std::ios::binary);
    out << text;
    if (!out.flush()) throw OptionError("cannot write '" + path + "': " + std::strerror(errno));
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
    const std::unique_ptr<Narrator> speaker = make_narrator(settings, streams);
    if (settings.json_file.empty()) return run_scene(settings, streams, *speaker, cancel);
    Journal journal(streams, *speaker, settings);
    const int status = run_scene(settings, streams, journal, cancel);
    write_journal(settings.json_file, journal.text(status));
    return status;
}

}  // namespace app
