#pragma once

#include "render/app/options/settings.h"
#include "render/app/run/cancellation.h"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

/// What the renderer (main.cpp) and the tools (tools/main.cpp) have in common as programs.
namespace app {

using Words = std::vector<std::string>;

/// The process's own, requested by a signal once heed_signals() has been called.
Cancellation& cancellation();
void heed_signals();

/// A command that ends early where a signal asks for it.
template <int (*Command)(const Words&, Cancellation&)>
int cancellable(const Words& arguments)
{
    heed_signals();
    return Command(arguments, cancellation());
}

/// What a word of options/sub_commands.h calls, with the words after it.
struct Called {
    std::string_view name;
    std::string (*help)();
    int (*run)(const Words& arguments);
};

bool wants_help(const Words& arguments);
bool has_word(const Words& arguments, std::initializer_list<std::string_view> words);

/// The command, or its help where a word asks for that; its name is the first of the arguments.
int call(const Called& command, const Words& arguments);

/// main(): errors are told, what was printed has to arrive, and nothing is cleaned up. `run` gets the words after the
/// program's name.
/// \param failure  status where standard output does not take what was printed
[[noreturn]] void run_program(int count, char** values, int (*run)(const Words&, Settings&, Remains&),
                              int failure = kError);

}  // namespace app
