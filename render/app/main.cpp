#include "render/app/command_line.h"
#include "render/app/compare_command.h"
#include "render/app/help.h"
#include "render/app/ini_file.h"
#include "render/app/render_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <unistd.h>

namespace {

app::Cancellation cancellation;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler uses them");

void cancel(int)
{
    const bool again = cancellation.requested.exchange(true);
    if (again || !cancellation.heeded) _exit(app::kCancelled);
}

bool has_word(const std::vector<std::string>& arguments, std::initializer_list<const char*> words)
{
    return std::any_of(arguments.begin(), arguments.end(), [&](const std::string& a) { return std::find(words.begin(), words.end(), a) != words.end(); });
}

void print_notes(const app::Settings& settings)
{
    for (const std::string& note : settings.notes) fmt::print(stderr, "note: {}\n", note);
    if (!settings.not_acted_on.empty()) fmt::print(stderr, "note: accepted without effect for now: {}\n", fmt::join(settings.not_acted_on, ", "));
}

int run(const std::vector<std::string>& arguments)
{
    if (!arguments.empty() && arguments[0] == "compare") return app::compare_command({arguments.begin() + 1, arguments.end()});
    if (has_word(arguments, {"--help", "-help", "-h", "-?"})) {
        fmt::print("{}", app::help_text());
        return app::kSuccess;
    }
    if (has_word(arguments, {"--version", "-version", "--V"})) {
        fmt::print("{}", app::version_text());
        return app::kSuccess;
    }
    for (const int signal : {SIGINT, SIGTERM, SIGQUIT, SIGPIPE}) std::signal(signal, cancel);
    app::Settings settings;
    app::read_default_ini_file(settings);
    app::apply_command_line(settings, arguments);
    print_notes(settings);
    return app::render_command(settings, cancellation);
}

}  // namespace

int main(int count, char** values)
{
    int status = app::kError;
    try {
        status = run({values + 1, values + count});
    } catch (const std::exception& error) {
        // A message with a place has its own "error:"; others get the program's name.
        const std::string text = error.what();
        const bool placed = text.find("error:") != std::string::npos;
        fmt::print(stderr, "{}{}\n", placed ? "" : "whittle: error: ", text);
    }
    std::fflush(nullptr);
    _exit(status);  // nothing to clean up: a picture library that is still loading would only delay the end
}
