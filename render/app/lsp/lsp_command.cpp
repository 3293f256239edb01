#include "render/app/lsp/lsp_command.h"

#include "render/app/base/library_path.h"
#include "render/app/lsp/server.h"
#include "render/app/options/command_line.h"
#include "render/app/options/ini_file.h"
#include "render/app/run/cancellation.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <unistd.h>

namespace app {
namespace {

constexpr const char* kLspUsage =
    R"(usage: whittle lsp [--seconds=N] [--memory=MB] [--no=NAME[,NAME...]] [options of a render]

A language server: an editor starts it and speaks with it over standard input and output. Diagnostics while typing, completion,
hover, definitions, references, outline, folds, colours, rename, layout. docs/editors.md tells how editors are set up.
+L, Declare=name=value and the like mean what they mean for a picture.
Exit status: 0 the client ended it in order, 1 the client went away.

  --seconds=N   a scene that takes longer to read is stopped and its loop is named; usual: 10
  --memory=MB   the same for one that takes more memory; usual: 2048
  --no=NAME     without these checks of whittle lint
  --stdio       changes nothing: editors say it
)";

constexpr unsigned kLastSeconds = 5;

struct LspRequest {
    Settings settings;
    lsp::Limits limits;
};

double lsp_number(const std::string& word, double most)
{
    const std::string_view value = std::string_view(word).substr(word.find('=') + 1);
    double number = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (error != std::errc() || end != value.data() + value.size() || !(number > 0) || number > most)
        throw OptionError(fmt::format("{} wants a number above 0, at most {}, found '{}'",
                                      word.substr(0, word.find('=')), most, value));
    return number;
}

void leave_out(const std::string& list, lint::Wanted& wanted)
{
    for (std::size_t at = 0; at <= list.size();) {
        const std::size_t end = std::min(list.find(',', at), list.size());
        const std::string name = list.substr(at, end - at);
        const auto known = lint::checks();
        if (std::none_of(known.begin(), known.end(), [&](const lint::Check& check) { return check.name == name; }))
            throw OptionError(fmt::format("no check is called '{}' (whittle lint --list names them)", name));
        wanted.off.insert(name);
        at = end + 1;
    }
}

LspRequest lsp_request(const std::vector<std::string>& arguments)
{
    LspRequest request;
    std::vector<std::string> others;
    for (const std::string& word : arguments) {
        if (word == "--stdio") continue;
        if (word.starts_with("--seconds=")) request.limits.seconds = lsp_number(word, 1e6);
        else if (word.starts_with("--memory="))
            request.limits.memory = static_cast<std::size_t>(lsp_number(word, 1e6)) << 20;
        else if (word.starts_with("--no=")) leave_out(word.substr(5), request.limits.lint);
        else others.push_back(word);
    }
    read_default_ini_file(request.settings);
    request.settings.input_file.clear();
    apply_command_line(request.settings, others);
    if (!request.settings.input_file.empty())
        throw OptionError(fmt::format("lsp takes no scene ('{}'): the editor sends them", request.settings.input_file));
    return request;
}

}  // namespace

std::string lsp_help() { return kLspUsage; }

int lsp_command(const std::vector<std::string>& arguments)
{
    const LspRequest request = lsp_request(arguments);
    std::signal(SIGPIPE, SIG_IGN);
    std::vector<std::string> library = request.settings.library_path;
    for (std::string& folder : default_library_path()) library.push_back(std::move(folder));

    rpc::Output output(STDOUT_FILENO);
    lsp::Server server(request.settings, request.limits, std::move(library), output);
    rpc::Input input(STDIN_FILENO,
                     [&] { return !output.gone() && (server.client() == 0 || ::kill(server.client(), 0) == 0); });
    std::string body;
    while (!output.gone()) {
        const rpc::Input::What what = input.next(body);
        if (what == rpc::Input::What::End) break;
        if (what == rpc::Input::What::TooLong) {
            server.complain(rpc::ErrorCode::InvalidRequest, "the message is too long");
            continue;
        }
        if (what == rpc::Input::What::Garbage) {
            server.complain(rpc::ErrorCode::ParseError, "a header with a Content-Length has to come first");
            continue;
        }
        try {
            if (!server.take(body)) break;
        } catch (const rpc::Refusal& refusal) {
            server.complain(refusal.code, refusal.what());
            // A length that was too great swallowed the next message.
            const std::size_t next = rpc::header_in(body);
            if (refusal.code == rpc::ErrorCode::ParseError && next != std::string::npos)
                input.put_back(std::string_view(body).substr(next));
        } catch (const std::exception& error) {
            server.complain(rpc::ErrorCode::InternalError, error.what());
        }
    }
    const bool well = server.ended_well();
    // What reads a scene ends when it is asked to; where it does not, the process does.
    std::signal(SIGALRM, [](int) { ::_exit(kError); });
    ::alarm(kLastSeconds);
    server.stop();
    ::alarm(0);
    return well ? kSuccess : kError;
}

}  // namespace app
