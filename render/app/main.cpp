#include "render/app/benchmark.h"
#include "render/app/editor/fmt_command.h"
#include "render/app/editor/lint_command.h"
#include "render/app/options/command_line.h"
#include "render/app/lsp/lsp_command.h"
#include "render/app/compare_command.h"
#include "render/app/options/help.h"
#include "render/app/options/ini_file.h"
#include "render/app/options/sub_commands.h"
#include "render/app/report/console_reporter.h"
#include "render/app/run/memory.h"
#include "render/app/pixel/pixel_command.h"
#include "render/app/picture/render_command.h"
#include "render/app/solid/info_command.h"
#include "render/app/solid/mesh_command.h"
#include "render/app/study/report_command.h"
#include "render/app/watch/watch_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <malloc.h>
#include <unistd.h>

namespace {

app::Cancellation cancellation;
const char* last_words = "cancelled\n";  // of a run that a signal ends where nobody looks for it
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler uses them");

void cancel(int)
{
    const bool again = cancellation.requested.exchange(true);
    if (!again && cancellation.heeded) return cancellation.wake();
    if (!again) { [[maybe_unused]] const auto written = write(STDERR_FILENO, last_words, std::strlen(last_words)); }
    _exit(app::kCancelled);
}

bool has_word(const std::vector<std::string>& arguments, std::initializer_list<const char*> words)
{
    return std::any_of(arguments.begin(), arguments.end(),
                       [&](const std::string& a) { return std::find(words.begin(), words.end(), a) != words.end(); });
}

/// A link called povray, povray-3.7 or the like: a program that calls it wants POV-Ray's console.
app::ConsoleStyle style_of(const std::string& program)
{
    return std::filesystem::path(program).filename().string().starts_with("povray") ? app::ConsoleStyle::Povray
                                                                                    : app::ConsoleStyle::Whittle;
}

/// What was printed has to arrive: `failure` where a status promises so and the file or pipe does not take it.
int with_output(int status, int failure)
{
    const bool arrived = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    if (arrived || status == failure || status == app::kCancelled) return status;
    fmt::print(stderr, "whittle: error: cannot write to standard output: {}\n", std::strerror(errno));
    return failure;
}

bool is_compare(const std::vector<std::string>& arguments) { return !arguments.empty() && arguments[0] == "compare"; }

void heed_signals()
{
    for (const int signal : {SIGINT, SIGTERM, SIGQUIT, SIGPIPE}) std::signal(signal, cancel);
}

using Words = std::vector<std::string>;

/// A command that ends early where a signal asks for it.
template <int (*Command)(const Words&, app::Cancellation&)>
int cancellable(const Words& arguments)
{
    heed_signals();
    return Command(arguments, cancellation);
}

/// What each word of options/sub_commands.h calls, with the words after it.
struct Called {
    std::string_view name;
    std::string (*help)();
    int (*run)(const Words& arguments);
};

// clang-format off: one a line
constexpr std::array kCalled = {
    Called{"compare", app::compare_help, app::compare_command},
    Called{"fmt", app::fmt_help, app::fmt_command},
    Called{"info", app::info_help, cancellable<app::info_command>},
    Called{"lint", app::lint_help, app::lint_command},
    Called{"lsp", app::lsp_help, app::lsp_command},
    Called{"mesh", app::mesh_help, cancellable<app::mesh_command>},
    Called{"pixel", app::pixel_help, cancellable<app::pixel_command>},
    Called{"report", app::report_help, cancellable<app::report_command>},
    Called{"watch", app::watch_help, cancellable<app::watch_command>},
};
// clang-format on
static_assert(kCalled.size() == app::kSubCommands.size());

int run(const std::vector<std::string>& arguments, app::Settings& settings, app::Remains& remains)
{
    const bool help = has_word(arguments, {"--help", "-help", "-h", "-?"});
    for (const Called& command : kCalled) {
        if (arguments.empty() || command.name != arguments[0]) continue;
        if (!help) return command.run({arguments.begin() + 1, arguments.end()});
        fmt::print("{}", command.help());
        return app::kSuccess;
    }
    if (help) {
        fmt::print("{}", app::help_text());
        return app::kSuccess;
    }
    if (has_word(arguments, {"--man"})) {
        fmt::print("{}", app::manual_page());
        return app::kSuccess;
    }
    if (has_word(arguments, {"--completion=zsh"})) {
        fmt::print("{}", app::zsh_completion());
        return app::kSuccess;
    }
    if (has_word(arguments, {"--completion", "--completion=bash"})) {
        fmt::print("{}", app::bash_completion());
        return app::kSuccess;
    }
    if (has_word(arguments, {"--version", "-version", "--V"})) {
        const bool called = settings.console_style == app::ConsoleStyle::Povray;  // POV-Ray keeps standard output clean
        fmt::print(called ? stderr : stdout, "{}", called ? app::povray_version_text() : app::version_text());
        return app::kSuccess;
    }
    heed_signals();
    app::read_default_ini_file(settings);
    if (has_word(arguments, {"--benchmark", "-benchmark"})) {
        app::apply_benchmark(settings);
        std::vector<std::string> others = arguments;
        std::erase_if(others, [](const std::string& word) { return word.ends_with("-benchmark"); });
        app::apply_command_line(settings, others);
    } else {
        app::apply_command_line(settings, arguments);
    }
    return app::render_command(settings, cancellation, remains);
}

/// What has been freed is used again before the system is asked for more: a page that comes anew is cleared first, and
/// lists that grow would pay for that at each size.
void keep_freed_memory()
{
#if defined(__GLIBC__)
    constexpr int kLargest = 32 << 20, kMostKept = 512 << 20, kAtOnce = 4 << 20;  // bytes
    mallopt(M_MMAP_THRESHOLD, kLargest);
    mallopt(M_TRIM_THRESHOLD, kMostKept);
    mallopt(M_TOP_PAD, kAtOnce);
#endif
}

}  // namespace

int main(int count, char** values)
{
    keep_freed_memory();
    const std::vector<std::string> arguments(values + std::min(count, 1), values + count);
    app::Settings settings;
    settings.console_style = style_of(count > 0 ? values[0] : "");
    if (settings.console_style == app::ConsoleStyle::Povray) last_words = "\nRender cancelled by user\n\n";
    int status = app::kError;
    app::Remains remains;  // until the process ends
    try {
        status = run(arguments, settings, remains);
    } catch (const std::exception& error) {
        const std::string text = app::text_of(error);
        app::journal_option_error(settings, text);
        app::tell_option_error(settings.console_style, fmt::format("{}", fmt::join(values, values + count, " ")), text);
    }
    status = with_output(status, is_compare(arguments) ? app::kNotCompared : app::kError);
    std::fflush(nullptr);
#ifdef WHITTLE_TRAIN
    std::exit(status);  // which writes what the kernels have counted
#endif
    _exit(status);  // nothing to clean up: a picture library that is still loading would only delay the end
}
