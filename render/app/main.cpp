#include "parser/grammar.h"
#include "render/app/benchmark.h"
#include "render/app/compare_command.h"
#include "render/app/join/join_command.h"
#include "render/app/options/command_line.h"
#include "render/app/options/help.h"
#include "render/app/options/ini_file.h"
#include "render/app/options/sub_commands.h"
#include "render/app/picture/render_command.h"
#include "render/app/program.h"
#include "render/app/run/stacks.h"
#include "render/image/codecs/module_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <unistd.h>

namespace {

using app::Words;

bool is_compare(const Words& arguments) { return !arguments.empty() && arguments[0] == "compare"; }

bool is_tool(const Words& arguments)
{
    return !arguments.empty() && std::any_of(app::kSubCommands.begin(), app::kSubCommands.end(),
                                             [&](const app::SubCommand& c) { return c.name == arguments[0]; });
}

/// Becomes the other program, which has all that a picture does not need.
[[noreturn]] void become_tools(const Words& arguments, bool as_povray)
{
    const std::string name = "whittle_tools";
    const auto program = image::find_module(name);
    if (!program) throw app::OptionError(image::missing_module(name));
    std::string called = as_povray ? "povray" : "whittle";
    std::vector<char*> words = {called.data()};
    Words copy = arguments;
    for (std::string& word : copy) words.push_back(word.data());
    words.push_back(nullptr);
    const std::filesystem::path own =
        image::program_file();  // what the tools have to start, wherever the shell found it
    if (!own.empty()) setenv("WHITTLE_PROGRAM", own.c_str(), 1);
    execv(program->c_str(), words.data());
    throw app::OptionError(fmt::format("cannot start '{}': {}", program->string(), std::strerror(errno)));
}

int run(const Words& arguments, app::Settings& settings, app::Remains& remains)
{
    if (is_compare(arguments)) return app::call({"compare", app::compare_help, app::compare_command}, arguments);
    if (!arguments.empty() && arguments[0] == "join" && !app::has_word(arguments, {"--movie"}))
        return app::call({"join", app::join_help, app::join_command}, arguments);
    if (is_tool(arguments)) become_tools(arguments, settings.console_style == app::ConsoleStyle::Povray);
    if (app::wants_help(arguments)) {
        fmt::print("{}", app::help_text());
        return app::kSuccess;
    }
    if (app::has_word(arguments, {"--man"})) {
        fmt::print("{}", app::manual_page());
        return app::kSuccess;
    }
    if (app::has_word(arguments, {"--grammar"})) {
        fmt::print("{}", parser::ebnf(parser::grammar()));
        return app::kSuccess;
    }
    if (app::has_word(arguments, {"--completion=zsh"})) {
        fmt::print("{}", app::zsh_completion());
        return app::kSuccess;
    }
    if (app::has_word(arguments, {"--completion", "--completion=bash"})) {
        fmt::print("{}", app::bash_completion());
        return app::kSuccess;
    }
    if (app::has_word(arguments, {"--version", "-version", "--V"})) {
        const bool called = settings.console_style == app::ConsoleStyle::Povray;  // POV-Ray keeps standard output clean
        fmt::print(called ? stderr : stdout, "{}", called ? app::povray_version_text() : app::version_text());
        return app::kSuccess;
    }
    app::heed_signals();
    app::deepen_stacks();
    app::read_default_ini_file(settings);
    if (app::has_word(arguments, {"--benchmark", "-benchmark"})) {
        app::apply_benchmark(settings);
        Words others = arguments;
        std::erase_if(others, [](const std::string& word) { return word.ends_with("-benchmark"); });
        app::apply_command_line(settings, others);
    } else {
        app::apply_command_line(settings, arguments);
    }
    return app::render_command(settings, app::cancellation(), remains);
}

}  // namespace

int main(int count, char** values)
{
    app::run_program(count, values, run,
                     is_compare({values + std::min(count, 1), values + count}) ? app::kNotCompared : app::kError);
}
