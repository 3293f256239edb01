#pragma once

#include <array>
#include <string_view>

namespace app {

/// A word that makes `whittle WORD ...` another program than the renderer.
struct SubCommand {
    std::string_view name;
    std::string_view synopsis;  ///< the words after the name
    std::string_view meaning;   ///< one line
};

/// All of them, in the order of the help text; what each calls stands in render/app/tools/main.cpp.
inline constexpr std::array kSubCommands = {
    SubCommand{"compare", "A B [--out diff.png] [--flip] [--tolerance n] [--share x]",
               "how far two pictures are apart"},
    SubCommand{"join", "OUT PART... | --check PART... | --movie OUT FRAME...",
               "one picture of the parts that --shard has rendered, or a film of frames"},
    SubCommand{"plan", "SCENE [--tasks=N] [--json] [--from=FOLDER] [options]",
               "what a job costs on many machines; docs/farm.md"},
    SubCommand{"farm", "SCENE --for=slurm|openjd|make|shell [--tasks=N] [-o FOLDER] [options]",
               "a folder that hands the job in; docs/farm.md"},
    SubCommand{"fmt", "FILE... [--check | --stdout]", "lay scene text out; docs/editors.md"},
    SubCommand{"lint", "SCENE [--no=NAME] [--only=NAME] [--list]", "what is doubtful about a scene; docs/editors.md"},
    SubCommand{"lsp", "[--seconds=N] [--memory=MB] [options]", "a language server for editors; docs/editors.md"},
    SubCommand{"mcp", "[--folder=FOLDER] [--seconds=N] [--memory=MB] [--pixels=N]",
               "tools for programs that write scenes, over the Model Context Protocol; docs/tools/agents.md"},
    SubCommand{"open", "PICTURE [-o FOLDER] [--list] [--replace]",
               "take out the scene that a picture of --embed carries"},
    SubCommand{"report", "SCENE... [-o report.html] [options]", "error against run time as a page"},
    SubCommand{"pixel", "SCENE X,Y [options]", "why a pixel has its colour, ray by ray"},
    SubCommand{"watch", "SCENE [--port=n] [options]", "a page that follows the scene's text (docs/watch.md)"},
    SubCommand{"info", "SCENE [--object=NAME] [--json] [--section=y,0.5 -o cut.svg]",
               "size, volume, surface and inertia of objects"},
    SubCommand{"mesh", "SCENE -o part.stl|.3mf|.obj|.ply [--tolerance=0.01] [--object=NAME]",
               "objects as closed triangle meshes"},
};

}  // namespace app
