#include "render/app/options/help.h"
#include "render/app/options/option_table.h"
#include "render/app/options/own_options.h"
#include "render/app/options/sub_commands.h"
#include "render/app/options/switch_table.h"

#include <fmt/format.h>

namespace app {

namespace {

/// Text as roff prints it: minus signs stay minus signs, nothing is taken for a request.
std::string roff(std::string_view text)
{
    std::string out;
    for (const char c : text) {
        if (c == '-') out += "\\-";
        else if (c == '\\') out += "\\e";
        else out += c;
    }
    return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

std::string man_entry(const std::string& name, std::string_view meaning)
{
    return ".TP\n.B " + roff(name) + "\n" + roff(meaning) + "\n";
}

constexpr const char* kBeginning = R"(.SH NAME
whittle \- renders POV-Ray scene files
.SH SYNOPSIS
.B whittle
.RI [ options ]
.I scene.pov
)";

constexpr const char* kDescription = R"(.SH DESCRIPTION
Whittle reads a scene in the language of POV-Ray 3.7 and writes a picture, by default a PNG file beside the scene.
It takes the switches and INI files of POV-Ray. Called by a name that begins with
.BR povray ,
it also speaks the lines of text that programs look for that call POV-Ray.
.PP
A word of the command line is a switch (+ turns on, \- turns off), Keyword=value, a scene (it ends in .pov), a library
folder (it ends in /) or an INI file, as name or name[section]. Each argument is split at blanks outside quotes. Words are
taken from left to right, and later ones win.
.PP
All text goes to standard error; standard output carries a picture
.RB ( +O\- ),
or what was asked to be printed. On a pipe or in a file the text is ASCII and not wrapped. The program never waits for a key.
)";

constexpr const char* kFiles = R"(.SH FILES
The first of these INI files that exists is read ahead of the command line: the one that the environment variable
.B POVINI
names, ./povray.ini, ~/.povray/3.7/povray.ini, /etc/povray/3.7/povray.ini, ~/.povrayrc. Without one the picture is 800x600;
with one that names no size it is 160x120.
.PP
Files that a scene includes are looked for in the current folder, the scene's, those of Library_Path, and the folders of an
installed package povray\-includes, or of the environment variable
.B WHITTLE_LIBRARY_PATH
(folders parted by colons). A scene may write files below the current folder and the picture's, and those of
.BR \-\-allow\-write .
.PP
A render that takes long keeps its finished blocks in a file beside the picture, with the extension .whittle\-state, which
.B +C
takes up again and which goes when the picture is there.
)";

std::string options_part()
{
    std::string page = ".SH OPTIONS\n";
    for (const OwnOption& option : own_options()) page += man_entry(option.form(), option.meaning);
    page += ".SH SWITCHES\n";
    for (const Switch& one : switch_table()) {
        const SwitchText shown = text_of(one);
        if (!shown.form.empty()) page += man_entry(shown.form, shown.meaning);
    }
    return page;
}

std::string keywords_part()
{
    struct Part {
        State state;
        const char* remark;
    };
    std::string page = ".SH INI KEYWORDS\n";
    for (const Part& part : {Part{State::Acts, ""}, Part{State::Settled, " (nothing to do here)"},
                             Part{State::NotYet, " (without effect for now)"}})
        for (const Option& option : option_table())
            if (option.state == part.state)
                page += man_entry(std::string(option.keyword), std::string(option.meaning) + part.remark);
    return page;
}

}  // namespace

std::string manual_page()
{
    std::string page = ".TH WHITTLE 1 \"\" \"whittle " WHITTLE_VERSION "\"\n";
    page += kBeginning;
    for (const SubCommand& command : kSubCommands)
        page += fmt::format(".br\n.B whittle {}\n{}\n", command.name, roff(command.synopsis));
    page += kDescription;
    page += ".SH COMMANDS\n";
    for (const SubCommand& command : kSubCommands) page += man_entry(std::string(command.name), command.meaning);
    page += options_part() + keywords_part();
    page += ".SH EXIT STATUS\n";
    for (const ExitStatus& status : kExitStatuses) page += man_entry(status.number, status.meaning);
    page += ".PP\nOf compare: 0 the pictures agree, 1 they differ, 2 they cannot be compared.\n.PP\nOf lint: 0 nothing "
            "was found, 1 something was, 2 the scene cannot be read.\n";
    return page + kFiles + ".SH SEE ALSO\n.BR povray (1)\n";
}

}  // namespace app
