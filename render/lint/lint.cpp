#include "render/lint/lint.h"

#include "parser/lexer/new_words.h"
#include "parser/stream/texts/quoted_text.h"
#include "render/lint/findings.h"

#include <fmt/format.h>

#include <algorithm>

namespace lint {
namespace {

constexpr Check kChecks[] = {
    {"endless-loop", "a #while whose condition nothing in it changes, or reading that does not end"},
    {"no-version", "the scene has no #version: what its words mean is guessed"},
    {"unused-name", "a #declare, #local or #macro of the scene that nothing uses"},
    {"missing-comma", "a name that is taken in place of the one before it because no comma stands between them"},
    {"negative-size", "a radius below 0"},
    {"zero-size", "a solid without extent: a radius of 0, a box that is a line or a point, equal ends"},
    {"flat-triangle", "a triangle of a mesh whose corners lie on a line"},
    {"no-pigment", "an object that is black because no pigment was given"},
    {"map-order", "entries of a map that are not in ascending order"},
    {"coincident-faces", "faces of a difference that lie in each other: which of them is seen is left to rounding"},
    {"no-light", "no light source, and nothing that glows"},
    {"light-inside", "a light inside of a solid that lets no light through"},
    {"camera-inside", "the camera stands inside of a solid"},
    {"empty-picture", "no object is in view"},
};

}  // namespace

std::span<const Check> checks() { return kChecks; }

const parser::SourceFile* Texts::file(const std::string& path)
{
    const auto known = files_.find(path);
    if (known != files_.end()) return known->second.get();
    std::unique_ptr<parser::SourceFile> made;
    if (std::optional<std::string> text = read_(path)) {
        made = std::make_unique<parser::SourceFile>();
        made->path = path;
        made->text = std::move(*text);
        parser::tokenize(*made, 0, names_, true, false);
        parser::settle_new_words(*made, names_);
    }
    return files_.emplace(path, std::move(made)).first->second.get();
}

void Findings::add_message(std::string_view check, scene::Message message)
{
    constexpr std::size_t kMost = 200;  // a loop that goes wrong would fill the screen
    if (found_.size() >= kMost || !wants(check)) return;
    if (!told_.insert(fmt::format("{} {}", check, scene::place_text(message.place))).second) return;
    if (const parser::SourceFile* file = message.place.at.line > 0 ? texts_.file(message.place.path) : nullptr)
        message.quote = parser::quoted_line(*file, message.place.at);
    message.severity = scene::Severity::Warning;
    message.text += fmt::format(" [{}]", check);
    found_.push_back({check, std::move(message)});
}

void Findings::add(std::string_view check, const scene::SourceRef& at, std::string text,
                   std::vector<std::pair<scene::SourceRef, std::string>> related)
{
    scene::Message message;
    message.text = std::move(text);
    message.place = description_->place(at);
    message.source = at;
    for (auto& [place, words] : related)
        if (place.somewhere()) message.related.push_back({description_->place(place), std::move(words)});
    add_message(check, std::move(message));
}

void Findings::add(std::string_view check, const std::string& path, std::uint32_t offset, std::string text)
{
    const parser::SourceFile* file = texts_.file(path);
    scene::Message message;
    message.text = std::move(text);
    message.place = {path, file ? file->locate(offset) : scene::LineAndColumn{}};
    add_message(check, std::move(message));
}

std::vector<Finding> Findings::take()
{
    const auto rank = [](const Finding& f) {
        return std::find_if(std::begin(kChecks), std::end(kChecks), [&](const Check& c) { return c.name == f.check; }) -
               std::begin(kChecks);
    };
    std::stable_sort(found_.begin(), found_.end(),
                     [&](const Finding& a, const Finding& b) { return rank(a) < rank(b); });
    return std::move(found_);
}

std::vector<Finding> check_text(const std::string& path, const std::vector<std::string>& others, const Reader& read,
                                const Wanted& wanted)
{
    Findings out(nullptr, read, wanted);
    check_loops(out, path, others);
    check_names(out, path, others);
    return out.take();
}

std::vector<Finding> check_messages(std::span<const scene::Message> messages, const Reader& read, const Wanted& wanted)
{
    Findings out(nullptr, read, wanted);
    for (const scene::Message& message : messages)
        if (!message.check.empty()) out.add_message(message.check, message);
    return out.take();
}

std::vector<Finding> check_scene(const scene::Description& description, const Reader& read, const Wanted& wanted,
                                 bool thorough)
{
    Findings out(&description, read, wanted);
    check_sizes(out, description);
    check_textures(out, description);
    if (thorough) {
        check_coincident(out, description);
        check_space(out, description);
    }
    return out.take();
}

Finding endless_loop(const scene::Message& at, double seconds)
{
    Finding out{"endless-loop", at};
    out.message.severity = scene::Severity::Warning;
    out.message.text =
        fmt::format("reading was stopped after {:g} s in this loop: does it end? [endless-loop]", seconds);
    return out;
}

}  // namespace lint
