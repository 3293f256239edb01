#include "render/app/watch/place/spotlight.h"

#include "language/names/files.h"
#include "render/app/rpc/guarded_json.h"
#include "render/app/run/scene_file.h"
#include "render/app/watch/place/focus.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <utility>

namespace app {
namespace {

using nlohmann::json;

constexpr std::size_t kMostNumbers = 12;
constexpr auto kCalm = std::chrono::milliseconds(150);
constexpr auto kEditorAnswers = std::chrono::milliseconds(400);

/// The scene's number of a file; nothing: it has not read it.
std::optional<std::size_t> file_number(const scene::Description& scene, const std::string& path)
{
    for (std::size_t i = 0; i < scene.files.size(); ++i)
        if (language::normal_path(scene.files[i]) == path) return i;
    return {};
}

json numbers_json(const Focus& focus, const language::Document& document, const NumberEdits* edits)
{
    json out = json::array();
    for (const FocusedNumber& number : focus.numbers) {
        const auto place = document.lines().place(number.range.begin);
        const auto set = edits != nullptr ? edits->numbers.find(number.range.begin) : decltype(edits->numbers.end()){};
        const bool is_set = edits != nullptr && set != edits->numbers.end();
        out.push_back({{"offset", number.range.begin},
                       {"line", place.line},
                       {"column", place.column},
                       {"word", number.word},
                       {"written", number.value},
                       {"value", is_set ? set->second.value : number.value},
                       {"set", is_set}});
    }
    return out;
}

/// The scene's places are those of the text that it was read from, with the numbers that a page has set.
std::uint32_t place_in_file(const Looked& looked, const std::string& file, const std::string& text,
                            scene::LineAndColumn at)
{
    const auto edits = looked.numbers.find(file);
    const bool changed = edits != looked.numbers.end() && edits->second.mark == mark_of(text);
    const scene::LineTable lines(changed ? edited(text, edits->second) : text);
    const std::uint32_t offset = lines.start(std::min(at.line, lines.lines())) + at.column - 1;
    return changed ? written_place(offset, edits->second) : offset;
}

}  // namespace

Spotlight::Spotlight(Newest newest, Told told)
    : newest_(std::move(newest)), told_(std::move(told)), thread_([this] { run(); }),
      mailbox_("watch", [this](const std::string& text, const std::string&) { take(text); })
{}

Spotlight::~Spotlight()
{
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    asked_.notify_all();
    thread_.join();
}

void Spotlight::renew()
{
    {
        const std::lock_guard lock(mutex_);
        if (!place_) return;
        waiting_ = renewed_ = true;
    }
    asked_.notify_all();
}

void Spotlight::point_at(Place place)
{
    {
        const std::lock_guard lock(mutex_);
        place_ = std::move(place);
        waiting_ = true;
    }
    asked_.notify_all();
}

void Spotlight::take(const std::string& text)
{
    const json message = json::parse(text, nullptr, false);
    if (!message.is_object()) return;
    if (message.contains("shown") || message.contains("written")) {
        const std::lock_guard lock(mutex_);
        ++answers_;
        answered_.notify_all();
        return;
    }
    const json* const file = rpc::find_member(message, {"cursor", "file"});
    if (!file || !file->is_string()) return;
    const auto number = [&](const char* name) {
        const json* const at = rpc::find_member(message, {"cursor", name});
        return at && at->is_number_unsigned() ? at->get<std::uint64_t>() : 0;
    };
    const std::shared_ptr<const Looked> looked = newest_();
    if (!looked || !file_number(*looked->scene, *file)) return;  // of another scene
    point_at(
        {*file, static_cast<std::uint32_t>(std::min<std::uint64_t>(number("offset"), UINT32_MAX)), number("mark")});
}

void Spotlight::run()
{
    for (;;) {
        Place place;
        {
            std::unique_lock lock(mutex_);
            asked_.wait(lock, [this] { return ending_ || waiting_; });
            if (ending_) return;
            // While pictures follow each other, as a slider moves, their time is theirs.
            while (std::exchange(renewed_, false)) asked_.wait_for(lock, kCalm, [this] { return ending_ || renewed_; });
            if (ending_) return;
            waiting_ = false;
            place = *place_;
        }
        try {
            if (const std::shared_ptr<const Looked> looked = newest_()) tell(place, looked);
        } catch (const std::exception&) {
            // A scene that cannot be compiled has said so where it is traced.
        }
    }
}

void Spotlight::tell(const Place& place, const std::shared_ptr<const Looked>& looked)
{
    const std::optional<std::string> text = text_on_disk(place.file);
    const std::optional<std::size_t> number = file_number(*looked->scene, place.file);
    if (!text || !number) return;
    json out{{"g", looked->generation},
             {"file", place.file},
             {"path", looked->scene->files[*number]},  // as messages name it
             {"numbers", json::array()},
             {"lit", nullptr}};
    const std::uint64_t mark = mark_of(*text);
    if (place.mark && *place.mark != mark) {
        out["why"] = "the editor's text is not saved";
        return told_(rpc::text_of(out));
    }
    const language::Document document(place.file, *text);
    const auto edits = looked->numbers.find(place.file);
    const bool changed = edits != looked->numbers.end() && edits->second.mark == mark;
    const Focus focus = focus_at(document, place.offset, kMostNumbers);
    const auto at = document.lines().place(focus.statements.empty() ? place.offset : focus.statements.front().begin);
    out["line"] = at.line;
    out["column"] = at.column;
    out["numbers"] = numbers_json(focus, document, changed ? &edits->second : nullptr);
    std::vector<language::Range> statements = focus.statements;
    if (changed)
        for (language::Range& range : statements)
            range = {edited_place(range.begin, edits->second), edited_place(range.end, edits->second)};
    if (const auto lit = lit_pixels(*seen(looked), *looked->scene, *number, statements))
        out["lit"] = {
            {"step", lit->step}, {"w", lit->width}, {"h", lit->height}, {"runs", lit->runs}, {"whole", lit->whole}};
    told_(rpc::text_of(out));
}

std::shared_ptr<const SeenPixels> Spotlight::seen(const std::shared_ptr<const Looked>& looked)
{
    const std::lock_guard lock(seeing_);
    if (seen_of_ != looked) {
        seen_ = std::make_shared<const SeenPixels>(looked->settings, *looked->scene, ending_);
        seen_of_ = looked;
    }
    return seen_;
}

bool Spotlight::shown_in_editor(const std::string& message)
{
    std::unique_lock lock(mutex_);
    const std::size_t before = answers_;
    if (mailbox_.tell("lsp", message) == 0) return false;
    return answered_.wait_for(lock, kEditorAnswers, [&] { return answers_ > before; });
}

web::Reply Spotlight::show(const std::string& body)
{
    const json wanted = json::parse(body, nullptr, false);
    const auto whole = [&](const char* name) {
        const auto at = wanted.is_object() ? wanted.find(name) : wanted.end();
        return wanted.is_object() && at != wanted.end() && at->is_number_integer() ? at->get<std::int64_t>() : -1;
    };
    const std::int64_t x = whole("x"), y = whole("y");
    const std::shared_ptr<const Looked> looked = newest_();
    if (!looked) return {409, "text/plain", "there is no picture yet\n"};
    if (x < 0 || y < 0 || x >= looked->settings.width || y >= looked->settings.height)
        return {400, "text/plain", "no such pixel\n"};
    std::optional<scene::Place> place;
    try {
        place = place_seen(*seen(looked), *looked->scene, static_cast<int>(x), static_cast<int>(y));
    } catch (const std::exception& error) {
        return {500, "text/plain", error.what()};
    }
    if (!place) return {200, "application/json", R"({"place":null})"};
    const std::string file = language::normal_path(place->path);
    scene::LineAndColumn at = place->at;
    if (const std::optional<std::string> text = text_on_disk(file)) {
        const std::uint32_t offset = place_in_file(*looked, file, *text, at);
        at = scene::LineTable(*text).place(offset);
        point_at({file, offset, {}});
    }
    const bool shown =
        shown_in_editor(rpc::text_of({{"show", {{"file", file}, {"line", at.line}, {"column", at.column}}}}));
    return {
        200, "application/json",
        rpc::text_of({{"place", {{"file", place->path}, {"line", at.line}, {"column", at.column}}}, {"shown", shown}})};
}

web::Reply Spotlight::write(const std::string& body)
{
    const json wanted = json::parse(body, nullptr, false);
    const std::shared_ptr<const Looked> looked = newest_();
    if (!looked || !wanted.is_object() || !wanted.contains("file") || !wanted["file"].is_string())
        return {400, "text/plain", "the numbers of which file?\n"};
    const auto edits = looked->numbers.find(wanted["file"].get<std::string>());
    if (edits == looked->numbers.end()) return {400, "text/plain", "none of its numbers was set\n"};
    json changes = json::array(), texts = json::array();
    for (const auto& [begin, number] : edits->second.numbers) {
        texts.push_back(number_text(number.value));
        changes.push_back({{"offset", begin}, {"length", number.end - begin}, {"text", texts.back()}});
    }
    const json edit{{"file", edits->first}, {"mark", edits->second.mark}, {"changes", std::move(changes)}};
    const bool written = shown_in_editor(rpc::text_of({{"edit", edit}}));
    return {200, "application/json", rpc::text_of({{"texts", std::move(texts)}, {"written", written}})};
}

}  // namespace app
