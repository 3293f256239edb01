#include "render/app/options/help.h"

#include "render/app/options/option_table.h"
#include "render/app/options/own_options.h"
#include "render/app/options/sub_commands.h"
#include "render/app/options/switch_table.h"

#include <fmt/format.h>

namespace app {

namespace {

constexpr std::size_t kColumns = 100;
constexpr std::size_t kIndent = 24;  // of meanings

constexpr const char* kUsage = R"(
A word is a switch (+ turns on, - turns off), Keyword=value, a scene (*.pov), a library folder (it ends in /) or an INI
file, name or name[section]. Later words win. +I- reads the scene from standard input, +O- writes the picture to standard
output; all text goes to standard error. The manual page says more: whittle --man | man -l -
)";

std::string usage()
{
    std::string text = "usage: whittle [options] scene.pov     renders to scene.png\n";
    for (const SubCommand& command : kSubCommands)
        text += fmt::format("       whittle {} {}\n", command.name, command.synopsis);
    return text + kUsage;
}

/// A name and what it means, the meaning wrapped at blanks.
std::string entry(const std::string& name, std::string_view meaning)
{
    std::string text = fmt::format("  {}", name), line;
    const bool fits = name.size() + 3 <= kIndent;
    text += fits ? "" : "\n";
    text.append(fits ? kIndent - 2 - name.size() : kIndent, ' ');
    for (std::size_t at = 0; at < meaning.size();) {
        const std::size_t blank = std::min(meaning.find(' ', at), meaning.size());
        const std::string_view word = meaning.substr(at, blank - at);
        if (!line.empty() && kIndent + line.size() + 1 + word.size() > kColumns) {
            text += line + "\n" + std::string(kIndent, ' ');
            line.clear();
        }
        (line += line.empty() ? "" : " ") += word;
        at = blank + 1;
    }
    return text + line + "\n";
}

std::string keywords_of(State state)
{
    std::string text, line(1, ' ');
    for (const Option& option : option_table()) {
        if (option.state != state) continue;
        if (line.size() + option.keyword.size() + 1 > kColumns) {
            text += line + "\n";
            line.resize(1);
        }
        (line += ' ') += option.keyword;
    }
    return text + line + "\n";
}

}  // namespace

std::string help_text()
{
    std::string text = usage();
    text += "\nWhittle's own options:\n";
    for (const OwnOption& option : own_options()) text += entry(option.form(), option.meaning);
    text += "\nSwitches:\n";
    for (const Switch& one : switch_table()) {
        const SwitchText shown = text_of(one);
        if (!shown.form.empty()) text += entry(shown.form, shown.meaning);
    }
    text += "\nINI keywords, each also as Keyword=value:\n";
    for (const Option& option : option_table())
        if (option.state == State::Acts) text += entry(std::string(option.keyword), option.meaning);
    text += "\nKeywords that need nothing here:\n" + keywords_of(State::Settled);
    text += "\nKeywords that are accepted without effect for now:\n" + keywords_of(State::NotYet);
    text += "\nExit status:\n";
    for (const ExitStatus& status : kExitStatuses) text += fmt::format("  {}  {}\n", status.number, status.meaning);
    return text + "  compare: 0 the pictures agree, 1 they differ, 2 they cannot be compared\n  lint: 0 nothing was "
                  "found, 1 something was, 2 the scene cannot be read\n";
}

std::string version_text() { return "whittle " WHITTLE_VERSION "\n"; }

std::string povray_version_text()
{
    return "POV-Ray 3.7.0.unofficial\n\nThis is Whittle " WHITTLE_VERSION
           ", an independent program that stands in for POV-Ray.\n";
}

}  // namespace app
