#include "render/app/editor/fmt_command.h"
#include "render/app/editor/lint_command.h"
#include "render/app/embed/open_command.h"
#include "render/app/farm/farm_command.h"
#include "render/app/farm/plan_command.h"
#include "render/app/film/movie_command.h"
#include "render/app/lsp/lsp_command.h"
#include "render/app/mcp/mcp_command.h"
#include "render/app/options/sub_commands.h"
#include "render/app/pixel/pixel_command.h"
#include "render/app/program.h"
#include "render/app/run/stacks.h"
#include "render/app/solid/info_command.h"
#include "render/app/solid/mesh_command.h"
#include "render/app/study/report_command.h"
#include "render/app/watch/watch_command.h"
#include "render/solid/measure/workers.h"

#include <fmt/format.h>

#include <array>

namespace {

// clang-format off: one a line
constexpr std::array kCalled = {
    app::Called{"farm", app::farm_help, app::cancellable<app::farm_command>},
    app::Called{"fmt", app::fmt_help, app::fmt_command},
    app::Called{"info", app::info_help, app::cancellable<app::info_command>},
    app::Called{"join", app::movie_help, app::movie_command},  // with --movie; of parts the renderer does it
    app::Called{"lint", app::lint_help, app::lint_command},
    app::Called{"lsp", app::lsp_help, app::lsp_command},
    app::Called{"mcp", app::mcp_help, app::mcp_command},
    app::Called{"mesh", app::mesh_help, app::cancellable<app::mesh_command>},
    app::Called{"open", app::open_help, app::open_command},
    app::Called{"pixel", app::pixel_help, app::cancellable<app::pixel_command>},
    app::Called{"plan", app::plan_help, app::cancellable<app::plan_command>},
    app::Called{"report", app::report_help, app::cancellable<app::report_command>},
    app::Called{"watch", app::watch_help, app::cancellable<app::watch_command>},
};
// clang-format on
static_assert(kCalled.size() + 1 == app::kSubCommands.size(), "but for compare, which the renderer does");

int run(const app::Words& arguments, app::Settings&, app::Remains&)
{
    app::deepen_stacks();
    solid::deepen_workers();  // solids are asked by TBB's own loops
    for (const app::Called& command : kCalled)
        if (!arguments.empty() && command.name == arguments[0]) return app::call(command, arguments);
    throw app::OptionError("this is a part of whittle and called by it");
}

}  // namespace

int main(int count, char** values) { app::run_program(count, values, run); }
