#include "render/app/watch/comparison.h"

#include "render/app/output/scratch_folder.h"
#include "render/app/rpc/guarded_json.h"
#include "render/app/watch/block_event.h"
#include "render/image/base64.h"
#include "render/image/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>

namespace app {
namespace {

using nlohmann::json;
using RunClock = std::chrono::steady_clock;

constexpr auto kLongestRun = std::chrono::minutes(10);
constexpr auto kLook = std::chrono::milliseconds(20);

/// Runs a program in a folder, told nothing and saying nothing. False: it failed, or was ended.
bool run_in(const std::string& folder, const std::vector<std::string>& words, const std::atomic<bool>& ending)
{
    std::vector<char*> raw;
    for (const std::string& word : words) raw.push_back(const_cast<char*>(word.c_str()));
    raw.push_back(nullptr);
    const pid_t parent = getpid();
    const pid_t child = fork();
    if (child < 0) return false;
    if (child == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);  // it does not outlive us
        const int nothing = open("/dev/null", O_RDWR);
        if (getppid() != parent || chdir(folder.c_str()) != 0) _exit(127);
        for (int stream : {0, 1, 2}) dup2(nothing, stream);
        execvp(raw[0], raw.data());
        _exit(127);
    }
    const auto last = RunClock::now() + kLongestRun;
    for (int status = 0;;) {
        if (waitpid(child, &status, WNOHANG) == child) return WIFEXITED(status) && WEXITSTATUS(status) == 0;
        if (ending || RunClock::now() > last) kill(child, SIGKILL);
        std::this_thread::sleep_for(kLook);
    }
}

}  // namespace

Comparison::~Comparison() { stop(); }

void Comparison::stop()
{
    ending_ = true;
    if (thread_.joinable()) thread_.join();
    ending_ = false;
}

void Comparison::refuse(const std::string& with, const std::string& why)
{
    events_.push(EventLog::Kind::Compared, rpc::text_of({{"with", with}, {"why", why}}));
}

void Comparison::show(const std::string& with, const std::string& path)
{
    const image::Picture picture = image::Files().read(path);
    std::string bytes;
    bytes.reserve(3 * picture.count());
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                const float value = picture.at(x, y)[picture.channels < 3 ? 0 : c];
                bytes += static_cast<char>(image::quantised(value, 8));
            }
    events_.push(EventLog::Kind::Compared, fmt::format(R"({{"with":"{}","W":{},"H":{},"c":3,"d":"{}"}})", with,
                                                       picture.width, picture.height, image::base64(bytes)));
}

void Comparison::show_reference()
{
    if (reference_.empty()) return refuse("reference", "none was given: --reference=picture.png");
    try {
        show("reference", reference_);
    } catch (const std::exception& error) {
        refuse("reference", error.what());
    }
}

void Comparison::run_povray(const std::string& scene, const Settings& settings)
{
    if (povray_.empty()) return refuse("povray", "POV-Ray is not installed");
    const std::lock_guard lock(mutex_);
    stop();
    thread_ = std::thread([this, scene, settings] { render(scene, settings); });
}

void Comparison::render(const std::string& scene, const Settings& settings)
{
    namespace fs = std::filesystem;
    try {
        const ScratchFolder scratch;
        const std::string picture = scratch / "picture.png";
        const fs::path file = fs::absolute(scene);
        // Whittle looks in the current folder and beside the scene; POV-Ray's current folder is the scratch.
        std::vector<std::string> words{povray_,
                                       "+I" + file.string(),
                                       "+O" + picture,
                                       "+FN8",
                                       "-D",
                                       "-P",
                                       fmt::format("+W{}", settings.width),
                                       fmt::format("+H{}", settings.height),
                                       fmt::format("+Q{}", settings.quality),
                                       "+L" + fs::current_path().string(),
                                       "+L" + file.parent_path().string()};
        for (const std::string& folder : settings.library_path) words.push_back("+L" + fs::absolute(folder).string());
        for (const auto& [name, value] : settings.declared_numbers)
            words.push_back(fmt::format("Declare={}={:.17g}", name, value));
        if (settings.clock) words.push_back(fmt::format("+K{:.9g}", *settings.clock));
        if (settings.antialias) {
            words.push_back(fmt::format("+A{:.9g}", settings.antialias_threshold));
            words.push_back(fmt::format("+AM{}", settings.sampling_method));
            words.push_back(fmt::format("+R{}", settings.antialias_depth));
            words.push_back(settings.jitter ? fmt::format("+J{:.9g}", settings.jitter_amount) : "-J");
        } else {
            words.push_back("-A");
        }
        if (settings.threads > 0) words.push_back(fmt::format("+WT{}", settings.threads));
        if (run_in(scratch / ".", words, ending_)) show("povray", picture);
        else if (!ending_) refuse("povray", "POV-Ray does not render this scene");
    } catch (const std::exception& error) {
        refuse("povray", error.what());
    }
}

}  // namespace app
