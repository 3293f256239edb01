#pragma once

#include "render/app/frames/frames.h"
#include "render/app/report/console_reporter.h"

#include <stdexcept>
#include <string>

namespace app {

/// What to do after a command (reference manual 3.2.6.3). Quit, UserAbort and Fatal leave the run by an exception.
enum class AfterCommand { GoOn, Skip, SkipAll };

struct QuitRun {};     ///< by a command's return action: end with status 0, no more commands
struct AbortedRun {};  ///< by a command's return action: as if the user had ended the run
struct FailedCommand : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Runs the commands of Pre_Scene_Command, Post_Frame_Command and so on if --allow-commands is given; else says that
/// they were not run.
class ShellCommands {
public:
    ShellCommands(const Settings& settings, const FrameList& list, ConsoleReporter& reporter)
        : settings_(settings), list_(list), reporter_(reporter)
    {}

    /// \param frame null outside of the frames
    AfterCommand run(Hook hook, const Frame* frame);
    /// The return action of a user's abort can make it an error. \return true for that
    bool abort_is_error(const Frame* frame);
    void fatal_error(const Frame* frame);  ///< its return action changes nothing

private:
    char execute(Hook hook, const Frame* frame);
    const Settings& settings_;
    const FrameList& list_;
    ConsoleReporter& reporter_;
};

/// The command with %o %s %n %k %h %w %% replaced (reference manual 3.2.6.1).
std::string substituted(const std::string& command, const Settings& settings, const FrameList& list,
                        const Frame* frame);

/// The letter of a return action (I S A Q U F) if it applies to an exit status, else 'I'. A letter alone applies to any
/// status but 0, one behind '-' or '!' to 0.
char triggered_action(const std::string& action, int status);

}  // namespace app
