#include "render/layers/object_names.h"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>
#include <string_view>
#include <unordered_map>

namespace layers {
namespace {

bool letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

std::string_view word_at(std::string_view text, std::size_t at)
{
    std::size_t end = at;
    while (end < text.size() && letter(text[end])) ++end;
    return text.substr(at, end - at);
}

/// The word that ends before `at`, blanks aside; `at` goes to its beginning.
std::string_view word_before(std::string_view text, std::size_t& at)
{
    while (at > 0 && blank(text[at - 1])) --at;
    const std::size_t end = at;
    while (at > 0 && letter(text[at - 1])) --at;
    return text.substr(at, end - at);
}

/// NAME where the text before the place reads "#declare NAME =".
std::string_view declared(std::string_view text, std::size_t at)
{
    while (at > 0 && blank(text[at - 1])) --at;
    if (at == 0 || text[--at] != '=') return {};
    const std::string_view name = word_before(text, at);
    const std::string_view directive = word_before(text, at);
    return directive == "declare" || directive == "local" ? name : std::string_view{};
}

/// NAME where the text at the place reads "object { NAME"; the place may be that of the word or of the name itself.
std::string_view used(std::string_view text, std::size_t at)
{
    if (word_at(text, at) != "object") {
        std::size_t before = at;
        while (before > 0 && blank(text[before - 1])) --before;
        if (before == 0 || text[before - 1] != '{') return {};
        return word_before(text, --before) == "object" ? word_at(text, at) : std::string_view{};
    }
    at += std::string_view("object").size();
    while (at < text.size() && blank(text[at])) ++at;
    if (at >= text.size() || text[at] != '{') return {};
    ++at;
    while (at < text.size() && blank(text[at])) ++at;
    const std::string_view name = word_at(text, at);
    std::size_t after = at + name.size();
    while (after < text.size() && blank(text[after])) ++after;
    const bool solid = after < text.size() && (text[after] == '{' || text[after] == '(');  // sphere {, a macro's call (
    return solid ? std::string_view{} : name;
}

}  // namespace

std::vector<std::string> object_names(const scene::Description& scene, const TextOf& text_of)
{
    std::vector<std::string> texts(scene.files.size());
    for (std::size_t i = 0; i < texts.size(); ++i) texts[i] = text_of(scene.files[i]);
    std::unordered_map<std::string, std::size_t> counts;
    std::vector<std::string> names;
    names.reserve(scene.objects.size());
    for (const scene::Object& object : scene.objects) {
        const scene::SourceRef& at = object.source;
        std::string name = "object";
        if (at.somewhere() && at.file < texts.size() && at.offset < texts[at.file].size()) {
            const std::string_view text = texts[at.file];
            std::string_view said = declared(text, at.offset);
            if (said.empty()) said = used(text, at.offset);
            name = !said.empty() ? std::string(said)
                                 : fmt::format("{} {}:{}", word_at(text, at.offset),
                                               std::filesystem::path(scene.files[at.file]).filename().string(),
                                               scene.lines[at.file].place(at.offset).line);
        }
        const std::size_t number = ++counts[name];
        names.push_back(number == 1 ? name : fmt::format("{}.{}", name, number));
    }
    return names;
}

}  // namespace layers
