#include "render/app/help.h"

#include "render/app/option_table.h"

#include <fmt/format.h>

namespace app {

namespace {

constexpr const char* kUsage = R"(usage: whittle [options] scene.pov     renders to scene.png
       whittle compare A B [--out diff.png] [--tolerance n] [--share x]

Common switches (POV-Ray's; + turns on, - turns off):
  +Iname     scene                      +Oname     picture; +O- is standard output
  +Wn +Hn    size in pixels (800x600)   +Fx[n]     N PNG, P PPM, T C Targa, J JPEG, B BMP, E OpenEXR, H Radiance; n bits
  +A0.3      antialiasing threshold     +AMn +Rn   its method and depth; +J jitter
  +Qn        quality, 0 to 11           +WTn       threads
  +Lpath     library path               +Kx        clock; +KFIn +KFFn frames of an animation
  +UA        alpha channel              +SRn +ERn +SCn +ECn   part of the picture
  Keyword=value sets an INI option, Declare=name=value a variable of the scene; another word names an INI file.

Whittle's own:
  --dump=tokens|scene|plan   print a stage's result and stop
  --explain                  say what the plan kept, what it left out and why
  --parse-only               read the scene and stop
  --isa=v2|v3|v4|auto        instruction set of the tracer
  --help, --version

compare: exit status 0 if at least a share (0.99) of the pixels are within n (3) of 255 in every channel, 1 if not, 2 if
the pictures cannot be compared.
Exit status of a render: 0 done, 1 error, 2 cancelled.
)";

std::string keywords_of(State state)
{
    constexpr std::size_t kColumns = 100;
    std::string text, line(1, ' ');
    for (const Option& option : option_table()) {
        if (option.state != state) continue;
        if (line.size() + option.keyword.size() + 1 > kColumns) {
            text += line;
            text += '\n';
            line.resize(1);
        }
        line += ' ';
        line += option.keyword;
    }
    text += line;
    text += '\n';
    return text;
}

}  // namespace

std::string help_text()
{
    return fmt::format("{}\nINI keywords that act:\n{}\nKeywords that need nothing here (display, bounding, preview, memory):\n{}\n"
                       "Keywords that are accepted without effect for now:\n{}",
                       kUsage, keywords_of(State::Acts), keywords_of(State::Settled), keywords_of(State::NotYet));
}

std::string version_text() { return "whittle " WHITTLE_VERSION "\n"; }

std::string povray_version_text()
{
    return "POV-Ray 3.7.0.unofficial\n\nThis is Whittle " WHITTLE_VERSION ", an independent program that stands in for POV-Ray.\n";
}

}  // namespace app
