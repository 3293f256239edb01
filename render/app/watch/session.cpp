#include "render/app/watch/session.h"

#include "csg/tree/program.h"
#include "parser/constants.h"
#include "render/app/pixel/pixel_answer.h"
#include "render/app/run/run.h"
#include "render/app/run/scene_file.h"
#include "render/app/run/scene_reading.h"
#include "render/app/run/stage_options.h"
#include "render/app/views/pivot.h"
#include "render/app/still/still.h"
#include "render/app/watch/passes.h"
#include "render/app/watch/scene_events.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdio>
#include <utility>

namespace app {
namespace {

using nlohmann::json;
using JobClock = std::chrono::steady_clock;

constexpr std::size_t kMostMessages = 200;  // that a page is told of one picture

double seconds_from(JobClock::time_point start)
{
    return std::chrono::duration<double>(JobClock::now() - start).count();
}

std::int64_t milliseconds_now()
{
    using std::chrono::milliseconds, std::chrono::system_clock;
    return std::chrono::duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

std::vector<scene::Message> messages_of_error(const std::exception& error)
{
    if (const auto* told = dynamic_cast<const scene::Error*>(&error)) return told->messages();
    return {{scene::Severity::Error, error.what(), {}, {}, {}, {}}};
}

void gather(void* list, const scene::Message& message)
{
    auto& messages = *static_cast<std::vector<scene::Message>*>(list);
    if (messages.size() < kMostMessages) messages.push_back(message);
}

std::optional<double> number_in(const json& from, const char* name)
{
    const auto at = from.find(name);
    if (at == from.end() || !at->is_number()) return {};
    const double value = *at;
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

View::Orbit orbit_in(const json& from)
{
    constexpr double kNearest = 1e-3, kFarthest = 1e3;
    View::Orbit out;
    out.yaw_deg = number_in(from, "yaw").value_or(0.0);
    out.pitch_deg = number_in(from, "pitch").value_or(0.0);
    out.dolly = std::clamp(number_in(from, "dolly").value_or(1.0), kNearest, kFarthest);
    out.right = number_in(from, "right").value_or(0.0);
    out.up = number_in(from, "up").value_or(0.0);
    return out;
}

std::optional<View::Cut> cut_in(const json& from)
{
    const auto normal = from.find("normal");
    if (normal == from.end() || !normal->is_array() || normal->size() != 3) return {};
    View::Cut cut;
    for (int i = 0; i < 3; ++i) {
        const json& one = (*normal)[static_cast<std::size_t>(i)];
        if (!one.is_number()) return {};
        cut.normal[i] = one;
    }
    const double length = glm::length(cut.normal);
    if (!(length > 0.0) || !std::isfinite(length)) return {};
    cut.normal /= length;
    cut.offset = number_in(from, "offset").value_or(0.0);
    return cut;
}

}  // namespace

Session::Session(const Settings& settings, const std::string& reference, const std::string& povray)
    : settings_(settings), scene_(find_scene(settings)), comparison_(events_, reference, povray),
      thread_([this] { run(); }), saves_([this] { ask(Cause::Save); })
{
    saves_.follow({scene_}, false);
    ask(Cause::Save);
}

Session::~Session()
{
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
        cancel_ = true;
        ending_early_ = true;
    }
    asked_.notify_all();
    events_.close();
    thread_.join();
}

void Session::ask(Cause cause)
{
    {
        const std::lock_guard lock(mutex_);
        if (waiting_ != Cause::Save) waiting_ = cause;  // a save that waits stays one: its text has to be read
        cancel_ = true;
    }
    asked_.notify_all();
}

void Session::run()
{
    for (;;) {
        View view;
        {
            std::unique_lock lock(mutex_);
            asked_.wait(lock, [this] { return ending_ || waiting_.has_value(); });
            if (ending_) return;
            if (*waiting_ == Cause::Save) unread_ = true;
            waiting_.reset();
            view = view_;
            cancel_ = false;
        }
        make(view);
    }
}

void Session::make(const View& view)
{
    ++generation_;
    try {
        render(view);
    } catch (const parser::Cancelled&) {
        return;
    } catch (const csg::Cancelled&) {
        return;
    } catch (const std::exception& error) {
        std::vector<scene::Message> messages = told_;
        for (scene::Message& message : messages_of_error(error)) messages.push_back(std::move(message));
        wrong_ = true;
        events_.push(EventLog::Kind::Messages, messages_event(generation_, true, messages), generation_);
        follow(true, messages);
    }
}

Settings Session::settings_for(const View& view) const
{
    Settings settings = settings_;
    if (view.clock) settings.clock = static_cast<float>(*view.clock);
    for (const auto& [name, value] : view.declared) settings.declared_numbers[name] = value;
    return settings;
}

void Session::read(const View& view, const Settings& settings)
{
    if (unread_ || wrong_) {  // else it is the same text with other values
        read_at_ = milliseconds_now();
        events_.push(EventLog::Kind::Text, text_event(generation_, scene_, read_at_));
    }
    const SceneReading reading(settings, cancel_);
    told_.clear();
    parsed_ = std::make_shared<const parser::Result>(parser::parse_file(scene_, reading.options, gather, &told_));
    read_with_ = view;
    wrong_ = unread_ = false;
    files_ = parsed_->scene.files;
    files_.insert(files_.end(), parsed_->data_files.begin(), parsed_->data_files.end());
    follow(false, told_);
}

/// What the next save may be of.
void Session::follow(bool wrong, const std::vector<scene::Message>& messages)
{
    std::vector<std::string> files = files_;
    files.push_back(scene_);
    for (const scene::Message& message : messages) {
        if (!message.place.path.empty()) files.push_back(message.place.path);
        for (const scene::RelatedPlace& related : message.related)
            if (!related.place.path.empty()) files.push_back(related.place.path);
    }
    saves_.follow(files, wrong);
}

void Session::render(const View& view)
{
    const auto start = JobClock::now();
    const Settings settings = settings_for(view);
    PassTimes times;
    if (unread_ || wrong_ || !view.same_text(read_with_)) {
        read(view, settings);
        times.emplace_back("parse", seconds_from(start));
    }
    events_.push(EventLog::Kind::Messages, messages_event(generation_, false, told_), generation_);
    const auto planning = JobClock::now();
    const plan::Options planned = plan_options(settings);
    std::optional<plan::CompiledScene> compiled;
    scene::Camera camera = parsed_->scene.camera;
    std::shared_ptr<const scene::Description> shown(parsed_, &parsed_->scene);
    if (view.orbit.still() && !view.cut) {
        compiled.emplace(plan::compile(parsed_->scene, planned));
    } else {
        auto other = std::make_shared<scene::Description>(parsed_->scene);
        scene::Description& changed = *other;
        if (!view.orbit.still()) {
            camera = moved(camera, view.orbit, pivot_distance(plan::compile(parsed_->scene, planned)));
            changed.camera = camera;
        }
        if (view.cut) cut_open(changed, *view.cut);
        compiled.emplace(plan::compile(std::as_const(changed), planned));
        shown = std::move(other);
    }
    {
        const std::lock_guard lock(mutex_);
        looked_ = std::make_shared<const Looked>(Looked{settings, std::move(shown)});
    }
    times.emplace_back("plan", seconds_from(planning));
    if (cancel_) return;
    events_.push(EventLog::Kind::Scene, scene_event(generation_, settings.width, settings.height, read_at_),
                 generation_);
    std::vector<parser::SceneConstant> constants = parser::constants_of(scene_);
    for (const auto& declared : settings_.declared_numbers)
        if (std::none_of(constants.begin(), constants.end(), [&](const auto& c) { return c.name == declared.first; }))
            constants.push_back({declared.first, declared.second});
    const double clock = static_cast<double>(settings.clock.value_or(0.0f));
    events_.push(EventLog::Kind::Controls, controls_event(view, clock, constants, camera_text(camera)), generation_);

    image::Encoding encoding = file_settings(settings, parsed_->scene).encoding;
    encoding.bits = 8;
    encoding.greyscale = false;
    encoding.dither = image::Dither::None;
    if (!trace_passes(*compiled, render_options(settings, cancel_), encoding, generation_, events_, times)) return;
    events_.push(EventLog::Kind::Done, done_event(generation_, seconds_from(start), times, nullptr), generation_);
}

web::Reply Session::change(const std::string& body)
{
    const json wanted = json::parse(body, nullptr, false);
    if (!wanted.is_object()) return {400, "text/plain", "expected a JSON object\n"};
    {
        const std::lock_guard lock(mutex_);
        if (const auto clock = wanted.find("clock"); clock != wanted.end()) view_.clock = number_in(wanted, "clock");
        if (const auto declared = wanted.find("declared"); declared != wanted.end() && declared->is_object()) {
            constexpr std::size_t kMostConstants = 100;
            view_.declared.clear();
            for (const auto& [name, value] : declared->items())
                if (value.is_number() && view_.declared.size() < kMostConstants) view_.declared[name] = value;
        }
        if (const auto orbit = wanted.find("orbit"); orbit != wanted.end())
            view_.orbit = orbit->is_object() ? orbit_in(*orbit) : View::Orbit{};
        if (const auto cut = wanted.find("cut"); cut != wanted.end())
            view_.cut = cut->is_object() ? cut_in(*cut) : std::nullopt;
    }
    ask(Cause::View);
    return {200, "application/json", "{}"};
}

web::Reply Session::compare(const std::string& body)
{
    const json wanted = json::parse(body, nullptr, false);
    const std::string with = wanted.is_object() && wanted.contains("with") && wanted["with"].is_string()
                                 ? wanted["with"].get<std::string>()
                                 : "";
    if (with == "reference") {
        comparison_.show_reference();
    } else if (with == "povray") {
        View view;
        {
            const std::lock_guard lock(mutex_);
            view = view_;
        }
        comparison_.run_povray(scene_, settings_for(view));
    } else {
        return {400, "text/plain", "compare with reference or povray\n"};
    }
    return {200, "application/json", "{}"};
}

web::Reply Session::pixel(const std::string& query)
{
    int x = -1, y = -1, length = -1;
    const bool read = std::sscanf(query.c_str(), "x=%9d&y=%9d%n", &x, &y, &length) == 2;
    if (!read || length != static_cast<int>(query.size()) || x < 0 || y < 0 || x >= settings_.width ||
        y >= settings_.height)
        return {400, "text/plain", "no such pixel\n"};
    std::shared_ptr<const Looked> looked;
    {
        const std::lock_guard lock(mutex_);
        looked = looked_;
    }
    if (!looked) return {409, "text/plain", "there is no picture yet\n"};
    const std::lock_guard one_at_a_time(explaining_);
    try {
        const PixelAnswer answer = pixel_answer(looked->settings, *looked->scene, x, y, ending_early_);
        return {
            200, "application/json",
            json{{"x", x}, {"y", y}, {"shown", {answer.shown.x, answer.shown.y, answer.shown.z}}, {"text", answer.text}}
                .dump(-1, ' ', false, json::error_handler_t::replace)};
    } catch (const std::exception& error) {
        return {500, "text/plain", error.what()};
    }
}

web::Reply Session::answer(bool posted, const std::string& path, const std::string& body)
{
    if (posted && path == "set") return change(body);
    if (posted && path == "compare") return compare(body);
    if (!posted && path == "pixel") return pixel(body);
    return {404, "text/plain", ""};
}

}  // namespace app
