#include "render/app/mcp/mcp_command.h"

#include "render/app/mcp/server.h"
#include "render/app/options/positive.h"
#include "render/app/run/exit_status.h"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <unistd.h>

namespace app {
namespace {

constexpr const char* kMcpUsage =
    R"(usage: whittle mcp [--folder=FOLDER] [--seconds=N] [--memory=MB] [--pixels=N] [+LFOLDER...]

A server of the Model Context Protocol over standard input and output, for programs that write scenes: tools that check, render, measure
and explain them. A client starts it; docs/tools/agents.md tells how. Each scene is read in a process of its own.
Exit status: 0 the client went away, 1 error.

  --folder=FOLDER  scenes may read files below it, and tools name files in it; usual: the current one. Nothing is written there
  --seconds=N      a tool that takes longer is stopped; usual: 20
  --memory=MB      the same for one that takes more memory; usual: 2048
  --pixels=N       of a picture, at most; usual: 1000000
  +LFOLDER         include files are searched, and read, there too
)";

mcp::Walls walls_of(const std::vector<std::string>& arguments)
{
    mcp::Walls walls;
    std::string folder = ".";
    for (const std::string& word : arguments) {
        const std::string value = word.substr(std::min(word.find('=') + 1, word.size()));
        if (word.starts_with("--folder=")) folder = value;
        else if (word.starts_with("--seconds=")) walls.limits.seconds = whole_positive("--seconds", value, 86400.0);
        else if (word.starts_with("--memory="))
            walls.limits.memory = static_cast<std::size_t>(whole_positive("--memory", value, 1e6)) << 20;
        else if (word.starts_with("--pixels=")) walls.pixels = whole_positive("--pixels", value, 1e9);
        else if (word.starts_with("+L") && word.size() > 2)
            walls.library.push_back(std::filesystem::absolute(word.substr(2)).lexically_normal().string());
        else throw OptionError("unknown option '" + word + "' (whittle mcp --help)");
    }
    std::error_code error;
    walls.folder = std::filesystem::canonical(folder, error).string();
    if (error || !std::filesystem::is_directory(walls.folder, error))
        throw OptionError("there is no folder '" + folder + "'");
    return walls;
}

}  // namespace

std::string mcp_help() { return kMcpUsage; }

int mcp_command(const std::vector<std::string>& arguments)
{
    mcp::Walls walls = walls_of(arguments);
    std::filesystem::current_path(walls.folder);
    std::signal(SIGPIPE, SIG_IGN);
    rpc::Output output(STDOUT_FILENO, rpc::Framing::Line);
    rpc::Input input(STDIN_FILENO, [&] { return !output.gone(); });
    mcp::Server(std::move(walls), input, STDIN_FILENO, output).serve();
    return kSuccess;
}

}  // namespace app
