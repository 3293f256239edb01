#include "render/app/watch/scene_events.h"

#include "render/app/rpc/guarded_json.h"

#include <nlohmann/json.hpp>

namespace app {
namespace {

using nlohmann::json;

json place_json(const scene::Place& place)
{
    if (place.path.empty()) return nullptr;
    json out{{"file", place.path}};
    if (place.at.line != 0) out["line"] = place.at.line, out["column"] = place.at.column;
    return out;
}

}  // namespace

std::string messages_event(int generation, bool wrong, const std::vector<scene::Message>& messages)
{
    json all = json::array();
    for (const scene::Message& message : messages) {
        json one{{"severity", name_of(message.severity)}, {"text", message.text}, {"place", place_json(message.place)}};
        if (message.quote) one["quote"] = message.quote->text, one["indent"] = message.quote->indent;
        one["related"] = json::array();
        for (const scene::RelatedPlace& related : message.related)
            one["related"].push_back({{"text", related.text}, {"place", place_json(related.place)}});
        all.push_back(std::move(one));
    }
    return rpc::text_of({{"g", generation}, {"wrong", wrong}, {"messages", std::move(all)}});
}

std::string text_event(int generation, const std::string& file, std::int64_t read_at)
{
    return rpc::text_of({{"g", generation}, {"file", file}, {"at", read_at}});
}

std::string scene_event(int generation, int width, int height, std::int64_t text, double clock, std::uint64_t request)
{
    return rpc::text_of({{"g", generation},
                         {"width", width},
                         {"height", height},
                         {"text", text},
                         {"clock", clock},
                         {"request", request}});
}

std::string done_event(int generation, double total, const PassTimes& times, const trace::RayCounts* rays)
{
    json out{{"g", generation}, {"total", total}, {"times", json::array()}};
    for (const auto& [name, seconds] : times) out["times"].push_back({name, seconds});
    if (rays != nullptr) out["rays"] = rays->camera + rays->shadow + rays->reflected + rays->refracted;
    return rpc::text_of(out);
}

std::string controls_event(const View& view, double clock, const std::vector<parser::SceneConstant>& constants,
                           const std::string& camera, const FrameList& frames)
{
    json out{{"clock", clock}, {"camera", camera}, {"constants", json::array()}, {"numbers", json::array()}};
    for (const parser::SceneConstant& constant : constants) {
        const auto set = view.declared.find(constant.name);
        const double value = set != view.declared.end() ? set->second : constant.value.value_or(0.0);
        out["constants"].push_back({{"name", constant.name}, {"value", value}, {"set", set != view.declared.end()}});
    }
    for (const auto& [file, edits] : view.numbers)
        for (const auto& [offset, number] : edits.numbers)
            out["numbers"].push_back({{"file", file}, {"offset", offset}, {"value", number.value}});
    if (frames.animation)
        out["frames"] = {{"count", frames.frames.size()},
                         {"first", frames.frames.front().clock},
                         {"last", frames.frames.back().clock}};
    const View::Orbit& o = view.orbit;
    out["orbit"] = {{"yaw", o.yaw_deg}, {"pitch", o.pitch_deg}, {"dolly", o.dolly}, {"right", o.right}, {"up", o.up}};
    if (view.cut)
        out["cut"] = {{"normal", {view.cut->normal.x, view.cut->normal.y, view.cut->normal.z}},
                      {"offset", view.cut->offset}};
    return rpc::text_of(out);
}

}  // namespace app
