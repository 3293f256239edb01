#include "render/app/watch/session.h"

#include "csg/tree/program.h"
#include "parser/constants.h"
#include "render/app/link/mailbox.h"
#include "render/app/pixel/pixel_answer.h"
#include "render/app/rpc/guarded_json.h"
#include "render/app/run/run.h"
#include "render/app/run/scene_file.h"
#include "render/app/run/scene_reading.h"
#include "render/app/run/stage_options.h"
#include "render/app/views/pivot.h"
#include "render/app/still/still.h"
#include "render/app/watch/block_event.h"
#include "render/app/watch/passes.h"
#include "render/app/watch/scene_events.h"
#include "render/app/watch/view_change.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <utility>

namespace app {
namespace {

using JobClock = std::chrono::steady_clock;

constexpr double kAtOnce = 0.03;            // seconds
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

/// Of an animation's options the frame that has the clock; where none has, a still of that clock.
void set_clock(Settings& settings, double clock)
{
    constexpr double kNear = 1e-6;  // pages count frames in another order of sums
    const FrameList list = frames_of(settings);
    const double near = kNear * std::max(1.0, std::abs(clock));
    for (const Frame& frame : list.frames)
        if (list.animation && std::abs(static_cast<double>(frame.clock) - clock) < near) {
            settings.frame_list = {{frame.number, frame.number, 1}};
            return;
        }
    settings.initial_frame = settings.final_frame = std::nullopt;
    settings.frame_list.clear();
    settings.clock = static_cast<float>(clock);
}

/// Of files whose text is another by now: should it come back, they would too.
void drop_stale(std::map<std::string, NumberEdits>& numbers)
{
    std::erase_if(numbers, [](const auto& one) {
        const auto text = text_on_disk(one.first);
        return !text || mark_of(*text) != one.second.mark;
    });
}

}  // namespace

Session::Session(const Settings& settings, const std::string& reference, const std::string& povray)
    : settings_(settings), comparison_(events_, reference, povray), wanted_scene_(find_scene(settings)),
      spotlight_(
          [this] {
              const std::lock_guard lock(mutex_);
              return looked_;
          },
          [this](const std::string& json) { events_.push(EventLog::Kind::Focus, json); }),
      gallery_(settings), scene_(wanted_scene_), thread_([this] { run(); }), saves_([this] { ask(Cause::Save); })
{
    saves_.follow({wanted_scene_}, false);
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
    gallery_.end();
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
        Cause cause;
        {
            std::unique_lock lock(mutex_);
            asked_.wait(lock, [this] { return ending_ || waiting_.has_value(); });
            if (ending_) return;
            cause = *waiting_;
            if (cause == Cause::Save) {
                unread_ = true;
                drop_stale(view_.numbers);
            }
            waiting_.reset();
            scene_ = wanted_scene_;
            view = view_;
            cancel_ = false;
        }
        make(view, cause);
    }
}

void Session::make(const View& view, Cause cause)
{
    ++generation_;
    try {
        render(view, cause);
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
    if (view.clock) set_clock(settings, *view.clock);
    for (const auto& [name, value] : view.declared) settings.declared_numbers[name] = value;
    return settings;
}

void Session::read(const View& view, const Settings& settings)
{
    if (unread_ || wrong_) {  // else it is the same text with other values
        read_at_ = milliseconds_now();
        events_.push(EventLog::Kind::Text, text_event(generation_, scene_, read_at_));
    }
    SceneReading reading(settings, cancel_);
    const std::map<std::string, std::string> texts = edited_texts(view);
    reading.options.texts = &texts;
    told_.clear();
    parsed_ = std::make_shared<const parser::Result>(parser::parse_file(scene_, reading.options, gather, &told_));
    read_with_ = view;
    wrong_ = unread_ = false;
    files_ = parsed_->scene.files;
    files_.insert(files_.end(), parsed_->data_files.begin(), parsed_->data_files.end());
    follow(false, told_);
}

/// Files whose numbers a page has set, as they are with them; those that are others by now are as they are.
std::map<std::string, std::string> Session::edited_texts(const View& view) const
{
    std::map<std::string, std::string> texts;
    for (const auto& [file, edits] : view.numbers)
        if (const auto text = text_on_disk(file); text && mark_of(*text) == edits.mark)
            texts[file] = edited(*text, edits);
    return texts;
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

void Session::render(const View& view, Cause cause)
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
        looked_ = std::make_shared<const Looked>(Looked{generation_, settings, std::move(shown), view.numbers});
    }
    times.emplace_back("plan", seconds_from(planning));
    if (cancel_) return;
    const double clock = static_cast<double>(frames_of(settings).frames.front().clock);
    events_.push(EventLog::Kind::Scene,
                 scene_event(generation_, settings.width, settings.height, read_at_, clock, view.request), generation_);
    std::vector<parser::SceneConstant> constants = parser::constants_of(scene_);
    for (const auto& declared : settings_.declared_numbers)
        if (std::none_of(constants.begin(), constants.end(), [&](const auto& c) { return c.name == declared.first; }))
            constants.push_back({declared.first, declared.second});
    events_.push(EventLog::Kind::Controls,
                 controls_event(view, clock, constants, camera_text(camera), frames_of(settings_)), generation_);

    const image::Encoding encoding = page_encoding(settings, parsed_->scene);
    // What is as fast as the eye is not shown coarse first: it follows a slider without flicker.
    const bool coarse = cause == Cause::Save || full_pass_ == 0 || full_pass_ > kAtOnce;
    if (!trace_passes(*compiled, render_options(settings, cancel_), encoding, coarse, generation_, events_, times))
        return;
    for (const auto& [name, seconds] : times)
        if (name == "1/1") full_pass_ = seconds;
    events_.push(EventLog::Kind::Done, done_event(generation_, seconds_from(start), times, nullptr), generation_);
    spotlight_.renew();
}

web::Reply Session::change(const std::string& body)
{
    std::shared_ptr<const Looked> looked;
    {
        const std::lock_guard lock(mutex_);
        looked = looked_;
    }
    const std::optional<ViewChange> change = view_change(body, looked.get());
    if (!change) return {400, "text/plain", "expected a JSON object\n"};
    {
        const std::lock_guard lock(mutex_);
        change->apply(view_);
    }
    ask(Cause::View);
    return {200, "application/json", "{}"};
}

web::Reply Session::compare(const std::string& body)
{
    const std::string with = rpc::string_of(body, "with");
    if (with == "reference") {
        comparison_.show_reference();
    } else if (with == "povray") {
        View view;
        {
            const std::lock_guard lock(mutex_);
            view = view_;
        }
        comparison_.run_povray(scene_wanted(), settings_for(view));
    } else {
        return {400, "text/plain", "compare with reference or povray\n"};
    }
    return {200, "application/json", "{}"};
}

std::string Session::scene_wanted()
{
    const std::lock_guard lock(mutex_);
    return wanted_scene_;
}

/// Another scene of the folder takes this one's place.
web::Reply Session::open(const std::string& body)
{
    const std::string path = Gallery::path_of(scene_wanted(), rpc::string_of(body, "name"));
    if (path.empty()) return {404, "text/plain", "no such scene\n"};
    {
        const std::lock_guard lock(mutex_);
        wanted_scene_ = path;
        view_ = {};
    }
    ask(Cause::Save);
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
        return {200, "application/json",
                rpc::text_of({{"x", x},
                              {"y", y},
                              {"shown", {answer.shown.x, answer.shown.y, answer.shown.z}},
                              {"text", answer.text}})};
    } catch (const std::exception& error) {
        return {500, "text/plain", error.what()};
    }
}

web::Reply Session::answer(bool posted, const std::string& path, const std::string& body)
{
    if (posted && path == "set") return change(body);
    if (posted && path == "compare") return compare(body);
    if (posted && path == "open") return open(body);
    if (!posted && path == "gallery") return gallery_.list(scene_wanted());
    if (!posted && path == "thumbnail") return gallery_.thumbnail(scene_wanted(), body);
    if (posted && path == "show") return spotlight_.show(body);
    if (posted && path == "write") return spotlight_.write(body);
    if (!posted && path == "pixel") return pixel(body);
    return {404, "text/plain", ""};
}

}  // namespace app
