#include "render/app/watch/view_change.h"

#include "language/names/files.h"
#include "render/app/link/mailbox.h"
#include "render/app/run/scene_file.h"
#include "render/app/watch/place/focus.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

using nlohmann::json;

std::optional<double> number_wanted(const json& from, const char* name)
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
    out.yaw_deg = number_wanted(from, "yaw").value_or(0.0);
    out.pitch_deg = number_wanted(from, "pitch").value_or(0.0);
    out.dolly = std::clamp(number_wanted(from, "dolly").value_or(1.0), kNearest, kFarthest);
    out.right = number_wanted(from, "right").value_or(0.0);
    out.up = number_wanted(from, "up").value_or(0.0);
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
    cut.offset = number_wanted(from, "offset").value_or(0.0);
    return cut;
}

/// Numbers that a page sets: those that stand where it says in files that the scene has read, and no others.
std::map<std::string, NumberEdits> numbers_in(const json& wanted, const Looked* looked)
{
    constexpr std::size_t kMostSet = 100;
    std::map<std::string, NumberEdits> out;
    std::map<std::string, language::Document> documents;
    if (!looked || wanted.size() > kMostSet) return out;
    for (const json& one : wanted) {
        if (!one.is_object() || !one.contains("file") || !one["file"].is_string() || !one.contains("offset") ||
            !one["offset"].is_number_unsigned())
            continue;
        const std::optional<double> value = number_wanted(one, "value");
        const std::string file = one["file"];
        const auto& files = looked->scene->files;
        const bool read =
            std::any_of(files.begin(), files.end(), [&](const auto& f) { return language::normal_path(f) == file; });
        if (!value || !read) continue;
        auto known = documents.find(file);
        if (known == documents.end()) {
            const auto text = text_on_disk(file);
            if (!text) continue;
            known = documents.try_emplace(file, file, *text).first;
            out[file].mark = mark_of(*text);
        }
        const auto offset = one["offset"].get<std::uint32_t>();
        const FocusedNumber number = number_at(known->second, offset);
        if (number.range.end > offset) out[file].numbers[offset] = {number.range.end, *value};
    }
    return out;
}

}  // namespace

void ViewChange::apply(View& view) const
{
    if (clock) view.clock = *clock;
    if (declared) view.declared = *declared;
    if (numbers) view.numbers = *numbers;
    if (orbit) view.orbit = *orbit;
    if (cut) view.cut = *cut;
    if (request) view.request = *request;
}

std::optional<ViewChange> view_change(const std::string& body, const Looked* looked)
{
    const json wanted = json::parse(body, nullptr, false);
    if (!wanted.is_object()) return {};
    ViewChange out;
    if (wanted.contains("clock")) out.clock = number_wanted(wanted, "clock");
    if (const auto declared = wanted.find("declared"); declared != wanted.end() && declared->is_object()) {
        constexpr std::size_t kMostConstants = 100;
        out.declared.emplace();
        for (const auto& [name, value] : declared->items())
            if (value.is_number() && out.declared->size() < kMostConstants) (*out.declared)[name] = value;
    }
    if (const auto set = wanted.find("numbers"); set != wanted.end() && set->is_array())
        out.numbers = numbers_in(*set, looked);
    if (const auto orbit = wanted.find("orbit"); orbit != wanted.end())
        out.orbit = orbit->is_object() ? orbit_in(*orbit) : View::Orbit{};
    if (const auto cut = wanted.find("cut"); cut != wanted.end())
        out.cut = cut->is_object() ? cut_in(*cut) : std::nullopt;
    if (const auto request = wanted.find("request"); request != wanted.end() && request->is_number_unsigned())
        out.request = request->get<std::uint64_t>();
    return out;
}

}  // namespace app
