#include "render/app/watch/watch_command.h"

#include "render/app/options/command_line.h"
#include "render/app/options/ini_file.h"
#include "render/app/options/positive.h"
#include "render/app/run/stage_options.h"
#include "render/app/run/run.h"
#include "render/app/run/scene_file.h"
#include "render/app/frames/window.h"
#include "render/app/study/povray_runs.h"
#include "render/app/watch/session.h"
#include "render/app/watch/web_module.h"
#include "render/picture/kernel_module.h"

#include <fmt/format.h>
#include <sys/random.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>

namespace app {
namespace {

constexpr const char* kWatchUsage = R"(usage: whittle watch SCENE [options]

Serves a page on 127.0.0.1 that shows the scene and follows its text: each save of the scene, or of a file that it reads, is rendered anew,
coarse to fine. Prints the page's address, which nobody can guess. Ctrl-C ends it.

  --port=N            the port; usual: any that is free
  --reference=FILE    a picture that the page compares with
  --povray=PROGRAM    the POV-Ray that it compares with, or off; usual: povray, where it is installed

All else is as for a render: +W +H, +A (usual: +A0.3; -A: none), +WT, +L, Declare=, +Q, --isa. Exit status: 1 error, 2 ended by a signal.
)";

struct WatchRequest {
    int port = 0;
    std::string reference, povray = "povray";
    Settings settings;
};

int port_of(const std::string& value)
{
    constexpr double kLastPort = 65535;
    const double port = whole_positive("--port", value, kLastPort);
    if (port != std::floor(port)) throw OptionError("--port wants a whole number, found '" + value + "'");
    return static_cast<int>(port);
}

WatchRequest watch_request_of(const std::vector<std::string>& arguments)
{
    WatchRequest request;
    read_default_ini_file(request.settings);
    std::vector<std::string> others;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& word = arguments[i];
        const std::size_t equals = word.find('=');
        const std::string name = word.substr(0, equals);
        if (name != "--port" && name != "--reference" && name != "--povray") {
            others.push_back(word);
            continue;
        }
        if (equals == std::string::npos && i + 1 == arguments.size()) throw OptionError(name + " wants a value");
        const std::string value = equals == std::string::npos ? arguments[++i] : word.substr(equals + 1);
        if (name == "--port") request.port = port_of(value);
        else if (name == "--reference") request.reference = value;
        else request.povray = value == "off" ? "" : value;
    }
    apply_command_line(request.settings, others);
    Settings& settings = request.settings;
    if (settings.input_file.empty())
        throw OptionError("no scene given: whittle watch scene.pov, or whittle watch --help");
    if (from_standard_input(settings)) throw OptionError("a scene from standard input cannot be watched");
    if (!std::filesystem::is_regular_file(find_scene(settings)))
        throw OptionError("there is no scene '" + settings.input_file + "'");
    if (settings.sampled())
        throw OptionError(
            "whittle watch has antialiasing (+A) alone: not --samples, --error, --time, Shutter or paths");
    window_of(settings);
    if (!settings.given.contains("Antialias")) settings.antialias = true;
    return request;
}

/// 128 bits in hexadecimal digits.
std::string random_token()
{
    std::array<unsigned char, 16> bytes{};
    if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
        throw std::runtime_error(std::string("no random numbers: ") + std::strerror(errno));
    std::string out;
    for (const unsigned char byte : bytes) out += fmt::format("{:02x}", byte);
    return out;
}

}  // namespace

std::string watch_help() { return kWatchUsage; }

int watch_command(const std::vector<std::string>& arguments, Cancellation& cancel)
{
    const WatchRequest request = watch_request_of(arguments);
    trace::load_kernel(isa_of(request.settings));
    cancel.heeded = true;
    const bool installed = PovrayRuns(request.povray).found();
    Session session(request.settings, request.reference, installed ? request.povray : "");
    const std::string token = random_token();
    const std::unique_ptr<web::Server> server = start_web_server(request.port, token, session);
    fmt::print("http://127.0.0.1:{}/{}/\n", server->port(), token);
    std::fflush(stdout);
    while (!cancel.requested) cancel.wait();
    return kCancelled;
}

}  // namespace app
