#include "render/app/picture/render_command.h"

#include "render/app/options/effective_ini.h"
#include "render/app/output/output_name.h"
#include "render/app/picture/frame_render.h"
#include "render/app/run/memory.h"
#include "render/app/report/journal.h"
#include "render/app/report/progress_lines.h"
#include "render/app/run/scene_file.h"
#include "render/app/run/shell_commands.h"
#include "render/app/run/stage_options.h"
#include "render/app/run/written_journal.h"
#include "render/app/views/views.h"
#include "render/files/whole_file.h"
#include "render/picture/kernel_module.h"

#include <fmt/format.h>

#include <cstdio>
#include <iterator>

namespace app {

namespace {

/// All frames, with the commands around them. `at` follows the frame at hand.
int render_frames(Run& run, ShellCommands& commands, const Frame*& at)
{
    if (commands.run(Hook::PreScene, nullptr) == AfterCommand::GoOn) {
        for (const Frame& frame : run.list.frames) {
            at = &frame;
            if (run.cancel.requested) throw AbortedRun();
            const AfterCommand before = commands.run(Hook::PreFrame, at);
            if (before == AfterCommand::Skip) continue;
            if (before == AfterCommand::SkipAll) break;
            if (render_frame(run, frame) == kCancelled) return kCancelled;
            if (commands.run(Hook::PostFrame, at) != AfterCommand::GoOn) break;
        }
    }
    at = nullptr;
    commands.run(Hook::PostScene, nullptr);
    run.reporter.finished();
    return kSuccess;
}

std::vector<scene::Message> messages_of(const std::exception& error)
{
    if (const auto* told = dynamic_cast<const scene::Error*>(&error)) return told->messages();
    return {{scene::Severity::Error, text_of(error), {}, {}, {}, {}}};
}

int fail(const std::exception& error, ConsoleReporter& reporter, ShellCommands& commands, const Frame* at)
{
    reporter.failed(messages_of(error));
    commands.fatal_error(at);
    return status_of(error);
}

int render_all(Run& run)
{
    ShellCommands commands(run.settings, run.list, run.reporter);
    const Frame* at = nullptr;
    try {
        if (render_frames(run, commands, at) != kCancelled) return kSuccess;
    } catch (const QuitRun&) {
        run.reporter.finished();
        return kSuccess;
    } catch (const AbortedRun&) {
        run.reporter.cancelled({});
    } catch (const std::exception& error) {
        return fail(error, run.reporter, commands, at);
    }
    if (commands.abort_is_error(at))
        return fail(std::runtime_error("ended by the user, and User_Abort_Return makes that an error"), run.reporter,
                    commands, at);
    return kCancelled;
}

/// Everything after the options are understood; errors are told.
int run_scene(const Settings& settings, Streams& streams, ConsoleReporter& reporter, Cancellation& cancel,
              Remains& remains)
{
    try {
        for (const std::string& note : settings.notes) reporter.note(note);
        if (!settings.not_acted_on.empty())
            reporter.note(fmt::format("accepted without effect for now: {}", fmt::join(settings.not_acted_on, ", ")));
        write_effective_ini(settings);
        Run run{settings, frames_of(settings), {}, streams, reporter, cancel, remains, {}};
        if (from_standard_input(settings)) run.input = files::rest_of(stdin);
        const bool traces = !settings.parse_only && settings.dump == Settings::Dump::None;
        if (traces) trace::load_kernel(isa_of(settings));
        if (traces && settings.output_to_file && settings.shards == 0) run.files.prepare(settings.file_type);
        return render_all(run);
    } catch (const std::exception& error) {
        reporter.failed(messages_of(error));
        return status_of(error);
    }
}

/// What cannot be rendered in parts.
void refuse_part(const Settings& settings)
{
    if (!settings.output_to_file || to_standard_output(settings) || to_standard_error(settings))
        throw OptionError("--shard and --prepare write files beside a picture: they go with one that has a name");
    if (settings.shards > 0 && settings.prepare)
        throw OptionError("--prepare comes before the parts: it does not go with --shard");
    if (plan_options(settings).grain_stream)
        throw OptionError("--faithful with one thread draws its random numbers from block to block, as POV-Ray does: a "
                          "part would have others");
}

void refuse_embedding(const Settings& settings)
{
    const image::FileType type = settings.file_type;
    if (type != image::FileType::Png && type != image::FileType::OpenExr)
        throw OptionError("--embed goes with PNG (+FN) and OpenEXR (+FE): other pictures have no room for a scene");
    if (settings.shards > 0 || settings.prepare)
        throw OptionError("--embed goes with whole pictures: parts of --shard become one without it");
}

}  // namespace

int render_command(const Settings& settings, Cancellation& cancel, Remains& remains)
{
    if (settings.input_file.empty()) throw OptionError("no scene given: whittle scene.pov, or whittle --help");
    if (settings.dump == Settings::Dump::Tokens) {
        fmt::print("{}", parser::dump_tokens(find_scene(settings)));
        return kSuccess;
    }
    refuse_contradictions(settings);
    if (settings.shards > 0 || settings.prepare) refuse_part(settings);
    if (!settings.views.empty()) refuse_views(settings);
    if (settings.dump == Settings::Dump::Views && settings.views.empty())
        throw OptionError("--dump=views prints the cameras of --views, which is not given");
    if (settings.embed) refuse_embedding(settings);
    Streams streams(settings);
    const std::unique_ptr<ConsoleReporter> speaker = make_reporter(settings, streams);
    std::unique_ptr<ConsoleReporter> teller;
    if (settings.progress != ProgressLines::None)
        teller = std::make_unique<ProgressTeller>(streams, *speaker, settings);
    ConsoleReporter& told = teller ? *teller : *speaker;
    if (settings.json_file.empty()) return run_scene(settings, streams, told, cancel, remains);
    Journal journal(streams, told, settings);
    const int status = run_scene(settings, streams, journal, cancel, remains);
    const int unwritten = write_journal(settings.json_file, journal.text(status));
    if (unwritten == 0 || status != kSuccess) return status;
    return files::failure_may_pass(unwritten) ? kTryAgain : kError;
}

}  // namespace app
