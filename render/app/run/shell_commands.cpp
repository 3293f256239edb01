#include "render/app/run/shell_commands.h"

#include "render/app/output/output_name.h"
#include "render/app/base/text.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

namespace app {

namespace {

constexpr const char* kHookNames[kHookCount] = {"Pre_Scene",  "Pre_Frame",  "Post_Frame",
                                                "Post_Scene", "User_Abort", "Fatal_Error"};

/// Exit status of the shell; what the command prints goes to standard error, which may carry text.
int shell_status(const std::string& command)
{
    const pid_t child = fork();
    if (child < 0) return 127;
    if (child == 0) {
        dup2(STDERR_FILENO, STDOUT_FILENO);
        execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
        _exit(127);
    }
    int result = 0;
    while (waitpid(child, &result, 0) < 0 && errno == EINTR) {}
    return WIFEXITED(result) ? WEXITSTATUS(result) : 128 + WTERMSIG(result);
}

}  // namespace

std::string substituted(const std::string& command, const Settings& settings, const FrameList& list, const Frame* frame)
{
    const FrameList unnumbered;  // outside of the frames the picture's name has no number
    std::string out;
    for (std::size_t i = 0; i < command.size(); ++i) {
        if (command[i] != '%' || i + 1 == command.size()) {
            out += command[i];
            continue;
        }
        switch (lower_case(command[++i])) {
        case 'o': out += output_path(settings, frame ? list : unnumbered, frame ? *frame : Frame{}); break;
        case 's': out += std::filesystem::path(settings.input_file).stem().string(); break;
        case 'n': out += std::to_string(frame ? frame->number : 0); break;
        case 'k': out += fmt::format("{:g}", frame ? frame->clock : 0.0f); break;
        case 'h': out += std::to_string(settings.height); break;
        case 'w': out += std::to_string(settings.width); break;
        case '%': out += '%'; break;
        default: (out += '%') += command[i];
        }
    }
    return out;
}

char triggered_action(const std::string& action, int status)
{
    std::string_view rest = trimmed(action);
    const bool reversed = !rest.empty() && (rest.front() == '-' || rest.front() == '!');
    if (reversed || (!rest.empty() && rest.front() == '+')) rest.remove_prefix(1);
    if (rest.empty() || (status != 0) == reversed) return 'I';
    const char letter = upper_case(rest.front());
    return std::string_view("SAQUF").find(letter) == std::string_view::npos ? 'I' : letter;
}

char ShellCommands::execute(Hook hook, const Frame* frame)
{
    const auto index = static_cast<std::size_t>(hook);
    const std::string& command = settings_.commands[index];
    if (command.empty()) return 'I';
    if (!settings_.allow_commands) {
        reporter_.note(
            fmt::format("the command of {}_Command is not run: that needs --allow-commands", kHookNames[index]));
        return 'I';
    }
    return triggered_action(settings_.command_returns[index],
                            shell_status(substituted(command, settings_, list_, frame)));
}

AfterCommand ShellCommands::run(Hook hook, const Frame* frame)
{
    switch (execute(hook, frame)) {
    case 'S': return AfterCommand::Skip;
    case 'A':
        if (hook == Hook::PreScene) throw QuitRun();
        return AfterCommand::SkipAll;
    case 'Q': throw QuitRun();
    case 'U': throw AbortedRun();
    case 'F':
        throw FailedCommand(fmt::format("{}_Command failed, and {}_Return makes that an error",
                                        kHookNames[static_cast<std::size_t>(hook)],
                                        kHookNames[static_cast<std::size_t>(hook)]));
    default: return AfterCommand::GoOn;
    }
}

bool ShellCommands::abort_is_error(const Frame* frame) { return execute(Hook::UserAbort, frame) == 'F'; }

void ShellCommands::fatal_error(const Frame* frame) { execute(Hook::FatalError, frame); }

}  // namespace app
