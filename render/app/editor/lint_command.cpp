#include "render/app/editor/lint_command.h"

#include "parser/parse.h"
#include "render/app/editor/replace_file.h"
#include "render/app/options/command_line.h"
#include "render/app/options/settings.h"
#include "render/app/run/run.h"
#include "render/app/frames/frames.h"
#include "render/app/run/cancellation.h"
#include "render/app/run/scene_file.h"
#include "render/app/run/scene_reading.h"
#include "render/app/run/stage_options.h"
#include "render/lint/lint.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace app {
namespace {

constexpr const char* kLintUsage =
    R"(usage: whittle lint SCENE [--no=NAME[,NAME...]] [--only=NAME[,NAME...]] [--seconds=N] [--list] [options of a render]

Tells what is doubtful about a scene that can be read. +L, +W, Declare=name=value and the like mean what they mean for a picture.
Exit status: 0 nothing was found, 1 something was, 2 the scene cannot be read.

  --list        the names of all checks and what they look for
  --no=NAME     without these checks
  --only=NAME   these checks alone
  --seconds=N   reading that takes longer does not end; usual: 10

)";

struct LintRequest {
    Settings settings;
    lint::Wanted wanted;
    double seconds = 10;
};

void name_checks(const std::string& list, std::set<std::string, std::less<>>& out)
{
    for (std::size_t at = 0; at <= list.size();) {
        const std::size_t end = std::min(list.find(',', at), list.size());
        const std::string name = list.substr(at, end - at);
        const auto known = lint::checks();
        if (std::none_of(known.begin(), known.end(), [&](const lint::Check& c) { return c.name == name; }))
            throw OptionError(fmt::format("no check is called '{}' (whittle lint --list names them)", name));
        out.insert(name);
        at = end + 1;
    }
}

LintRequest lint_request(const std::vector<std::string>& arguments)
{
    LintRequest request;
    std::vector<std::string> others;
    std::set<std::string, std::less<>> only;
    for (const std::string& word : arguments) {
        const std::string value = word.substr(std::min(word.find('=') + 1, word.size()));
        if (word.starts_with("--no=")) name_checks(value, request.wanted.off);
        else if (word.starts_with("--only=")) name_checks(value, only);
        else if (word.starts_with("--seconds=")) {
            const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), request.seconds);
            if (error != std::errc() || end != value.data() + value.size() || !(request.seconds > 0) ||
                request.seconds > 1e6)
                throw OptionError(fmt::format("--seconds wants a number above 0, found '{}'", value));
        } else others.push_back(word);
    }
    if (!only.empty())
        for (const lint::Check& check : lint::checks())
            if (!only.contains(check.name)) request.wanted.off.emplace(check.name);
    apply_command_line(request.settings, others);
    if (request.settings.input_file.empty()) throw OptionError("lint wants a scene: whittle lint scene.pov");
    return request;
}

/// Sets a flag when the time is over.
class Deadline {
public:
    Deadline(double seconds, std::atomic<bool>& flag)
        : thread_([this, seconds, &flag] {
              std::unique_lock lock(mutex_);
              if (!done_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return over_; })) flag = true;
          })
    {}
    ~Deadline()
    {
        {
            const std::lock_guard lock(mutex_);
            over_ = true;
        }
        done_.notify_one();
        thread_.join();
    }
    Deadline(const Deadline&) = delete;
    Deadline& operator=(const Deadline&) = delete;

private:
    std::mutex mutex_;
    std::condition_variable done_;
    bool over_ = false;
    std::thread thread_;
};

void keep_note(void* context, const parser::Message& message)
{
    if (message.severity == parser::Severity::Note) *static_cast<parser::Message*>(context) = message;
}

void append(std::vector<lint::Finding>& to, std::vector<lint::Finding> from)
{
    std::move(from.begin(), from.end(), std::back_inserter(to));
}

std::vector<lint::Finding> look_at(const LintRequest& request)
{
    const Settings& settings = request.settings;
    const std::string scene = find_scene(settings);
    std::atomic<bool> late = false;
    parser::Message stopped;
    const SceneReading reading(settings, late);
    std::vector<lint::Finding> found;
    try {
        parser::Result parsed;
        {
            const Deadline deadline(request.seconds, late);
            parsed = parser::parse_file(scene, reading.options, keep_note, &stopped);
        }
        append(found, lint::check_text(scene, parsed.scene.files, text_on_disk, request.wanted));
        append(found, lint::check_messages(parsed.messages, text_on_disk, request.wanted));
        append(found, lint::check_scene(parsed.scene, text_on_disk, request.wanted));
    } catch (const parser::Cancelled&) {
        append(found, lint::check_text(scene, {}, text_on_disk, request.wanted));
        if (request.wanted.wants("endless-loop")) found.push_back(lint::endless_loop(stopped, request.seconds));
    }
    return found;
}

}  // namespace

std::string lint_help()
{
    std::string text = kLintUsage;
    for (const lint::Check& check : lint::checks()) text += fmt::format("  {:<18}{}\n", check.name, check.meaning);
    return text;
}

int lint_command(const std::vector<std::string>& arguments)
{
    const auto has = [&](const char* word) {
        return std::find(arguments.begin(), arguments.end(), word) != arguments.end();
    };
    if (has("--list")) {
        for (const lint::Check& check : lint::checks()) fmt::print("{:<18}{}\n", check.name, check.meaning);
        return kSuccess;
    }
    const LintRequest request = lint_request(arguments);
    try {
        const std::vector<lint::Finding> found = look_at(request);
        for (const lint::Finding& finding : found) fmt::print("{}\n", scene::message_text(finding.message));
        return found.empty() ? kNothingFound : kFound;
    } catch (const scene::Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return kUnreadable;
    }
}

}  // namespace app
