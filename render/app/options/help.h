#pragma once

#include <string>

/// The program's texts about itself, all made from the tables of options (own_options.h, switch_table.h,
/// option_table.h).
namespace app {

/// --help: usage, Whittle's options, switches, and every INI keyword with what becomes of it.
std::string help_text();

/// --man: the manual page whittle(1) in the form that man reads.
std::string manual_page();

/// --completion: completes options, switches, keywords and files in bash, for whittle and povray.
std::string bash_completion();
std::string zsh_completion();

/// --version.
std::string version_text();

/// The same under the name povray: callers look for "POV-Ray" and "official" in one line.
std::string povray_version_text();

/// What the exit statuses mean, a line each: "0", "done", ...
struct ExitStatus {
    const char *number, *meaning;
};
inline constexpr ExitStatus kExitStatuses[] = {
    {"0", "done; also a picture that +C found and left"},
    {"1", "an error: of the options, the scene, the picture's file; nothing was written over"},
    {"2", "ended by SIGINT, SIGTERM, SIGQUIT or SIGPIPE; what was finished is kept for +C"},
    {"75", "another try may go well: a disk that is full, memory that is gone, a file that went while it was read"},
};

}  // namespace app
