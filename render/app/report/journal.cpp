#include "render/app/report/journal.h"

#include "render/app/report/json_writer.h"

#include <fmt/format.h>

#include <sys/resource.h>

namespace app {

void Journal::begin(const FrameFacts& facts)
{
    FrameRecord& frame = frames_.emplace_back();
    frame.number = facts.frame.number;
    frame.clock = static_cast<double>(facts.frame.clock);
    frame.scene = facts.scene;
    frame.picture = facts.picture;
    speaker_.begin(facts);
}

void Journal::message(const scene::Message& message)
{
    if (!frames_.empty()) frames_.back().messages.push_back(message);
    speaker_.message(message);
}

void Journal::parsed(const parser::Result& result, const StageTimes& times)
{
    FrameRecord& frame = frames_.back();
    frame.parser = result.statistics;
    frame.files = result.scene.files;
    frame.files.insert(frame.files.end(), result.data_files.begin(), result.data_files.end());
    frame.objects = result.scene.objects.size();
    frame.phases = times.stages();
    speaker_.parsed(result, times);
}

void Journal::pass(const std::string& name)
{
    const double now = std::chrono::duration<double>(Clock::now() - start_).count(), processor = processor_seconds();
    std::vector<Pass>& passes = frames_.back().passes;
    if (!passes.empty()) {
        passes.back().seconds = now - passes.back().seconds;
        passes.back().processor_seconds = processor - passes.back().processor_seconds;
    }
    passes.push_back({name, now, processor});
    speaker_.pass(name);
}

void Journal::made_from(const std::string& fingerprint)
{
    frames_.back().fingerprint = fingerprint;
    speaker_.made_from(fingerprint);
}

void Journal::rendered(const StageTimes& times, const trace::RenderStatistics& statistics)
{
    FrameRecord& frame = frames_.back();
    frame.phases = times.stages();
    frame.statistics = statistics;
    speaker_.rendered(times, statistics);
}

void Journal::written(const std::string& path)
{
    FrameRecord& frame = frames_.back();
    frame.written = true;
    frame.pictures.push_back({path, frame.fingerprint});
    frame.picture = frame.pictures.front().path;
    speaker_.written(path);
}

void Journal::skipped(const std::string& path)
{
    const bool read = !frames_.empty() && frames_.back().picture == path;  // to compare its fingerprint
    FrameRecord& frame = read ? frames_.back() : frames_.emplace_back();
    frame.skipped = true;
    frame.picture = path;
    speaker_.skipped(path);
}

void Journal::note(const std::string& text)
{
    notes_.push_back({scene::Severity::Note, text, {}, {}, {}, {}});
    speaker_.note(text);
}

void Journal::cancelled(const Kept& kept)
{
    cancelled_ = true;
    if (!frames_.empty()) frames_.back().kept = kept;
    speaker_.cancelled(kept);
}

void Journal::failed(const std::vector<scene::Message>& errors)
{
    errors_ = errors;
    speaker_.failed(errors);
}

void Journal::finished() { speaker_.finished(); }

namespace {

void put_place(JsonWriter& json, const scene::Place& place)
{
    if (place.path.empty()) return;
    json.key("file").text(place.path);
    if (place.at.line == 0) return;
    json.key("line").integer(place.at.line);
    json.key("column").integer(place.at.column);
}

void put_message(JsonWriter& json, const scene::Message& message)
{
    json.begin_object();
    json.key("severity").text(name_of(message.severity));
    put_place(json, message.place);
    json.key("text").text(message.text);
    if (!message.place.path.empty()) json.key("shown").text(message_text(message));
    if (!message.related.empty()) {
        json.key("related").begin_array();
        for (const scene::RelatedPlace& one : message.related) {
            json.begin_object();
            put_place(json, one.place);
            json.key("text").text(one.text);
            json.key("times").integer(static_cast<std::int64_t>(one.times));
            json.end();
        }
        json.end();
    }
    json.end();
}

}  // namespace

void Journal::put_frame(JsonWriter& json, const FrameRecord& frame) const
{
    json.begin_object();
    if (frame.skipped) {
        json.key("skipped").truth(true);
        json.key("picture").text(frame.picture);
        if (!frame.fingerprint.empty()) json.key("fingerprint").text(frame.fingerprint);
        return json.end();
    }
    json.key("number").integer(frame.number);
    json.key("clock").number(frame.clock);
    json.key("scene").text(frame.scene);
    json.key("picture");
    if (frame.written) json.text(frame.picture);
    else json.null();
    if (frame.pictures.size() > 1) {
        json.key("views").begin_array();
        for (const Picture& view : frame.pictures) {
            json.begin_object();
            json.key("picture").text(view.path);
            json.key("fingerprint").text(view.fingerprint);
            json.end();
        }
        json.end();
    } else if (!frame.fingerprint.empty()) {
        json.key("fingerprint").text(frame.fingerprint);
    }
    if (!frame.kept.state.empty()) json.key("state").text(frame.kept.state);
    if (!frame.kept.picture.empty()) json.key("partial").text(frame.kept.picture);
    json.key("phases").begin_object();
    for (const StageTimes::Stage& phase : frame.phases) {
        json.key(fmt::format("{}_seconds", phase.name)).number(phase.seconds);
        json.key(fmt::format("{}_cpu_seconds", phase.name)).number(phase.processor_seconds);
    }
    json.end();
    if (frame.statistics && frame.passes.size() > 1) {
        json.key("passes").begin_array();
        for (auto pass = frame.passes.begin(); pass + 1 != frame.passes.end(); ++pass) {
            json.begin_object();
            json.key("name").text(pass->name);
            json.key("seconds").number(pass->seconds);
            json.key("cpu_seconds").number(pass->processor_seconds);
            json.end();
        }
        json.end();
    }
    json.key("counts").begin_object();
    const auto count = [&](const char* name, std::uint64_t value) {
        json.key(name).integer(static_cast<std::int64_t>(value));
    };
    count("files", frame.parser.files);
    count("bytes", frame.parser.bytes);
    count("tokens", frame.parser.tokens);
    count("macro_calls", frame.parser.macro_calls);
    count("objects", frame.objects);
    if (frame.statistics) {
        const trace::RayCounts& rays = frame.statistics->rays;
        count("camera_rays", rays.camera);
        count("shadow_rays", rays.shadow);
        count("reflected_rays", rays.reflected);
        count("refracted_rays", rays.refracted);
        count("supersamples", rays.supersamples);
        if (frame.statistics->samples > 0) count("samples", frame.statistics->samples);
    }
    json.end();
    if (frame.statistics) {
        json.key("threads").integer(frame.statistics->threads);
        json.key("isa").text(frame.statistics->isa);
        if (frame.statistics->samples > 0) json.key("expected_error").number(frame.statistics->error);
    }
    json.key("files").begin_array();
    for (const std::string& file : frame.files) json.text(file);
    json.end();
    json.key("reading").begin_array();
    for (const parser::ReadingCost& cost : frame.parser.costs) {
        json.begin_object();
        json.key("what").text(cost.what);
        json.key("name").text(cost.name);
        json.key("place").text(cost.place);
        json.key("seconds").number(cost.seconds);
        json.key("own_seconds").number(cost.own_seconds);
        json.end();
    }
    json.end();
    json.key("messages").begin_array();
    for (const scene::Message& message : frame.messages) put_message(json, message);
    json.end();
    json.end();
}

std::string Journal::text(int status) const
{
    JsonWriter json;
    json.begin_object();
    json.key("program").text("whittle");
    json.key("version").text(WHITTLE_VERSION);
    json.key("exit_status").integer(status);
    json.key("result").text(cancelled_ ? "cancelled" : status == 0 ? "done" : "failed");
    json.key("seconds").number(std::chrono::duration<double>(Clock::now() - start_).count());
    json.key("processor_seconds").number(processor_seconds());
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    json.key("peak_memory_bytes").integer(static_cast<std::int64_t>(usage.ru_maxrss) * 1024);
    json.key("width").integer(settings_.width);
    json.key("height").integer(settings_.height);
    json.key("options").begin_object();
    for (const auto& [keyword, values] : settings_.given) {
        json.key(keyword);
        if (keyword != "Library_Path" && keyword != "Declare") {
            json.text(values.back());
            continue;
        }
        json.begin_array();
        for (const std::string& value : values) json.text(value);
        json.end();
    }
    json.end();
    json.key("ini_files").begin_array();
    for (const std::string& file : settings_.ini_files) json.text(file);
    json.end();
    json.key("messages").begin_array();
    for (const scene::Message& note : notes_) put_message(json, note);
    for (const scene::Message& error : errors_) put_message(json, error);
    json.end();
    json.key("frames").begin_array();
    for (const FrameRecord& frame : frames_) put_frame(json, frame);
    json.end();
    json.end();
    return json.take();
}

}  // namespace app
