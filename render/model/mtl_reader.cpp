#include "render/model/mtl_reader.h"

#include "render/model/base/text_words.h"

#include <algorithm>
#include <unordered_map>

namespace model {
namespace {

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view kBlank = " \t\r\f\v";
    text.remove_prefix(std::min(text.find_first_not_of(kBlank), text.size()));
    text.remove_suffix(text.size() - (text.find_last_not_of(kBlank) + 1));
    return text;
}

/// One number or three; `Kd spectral f` and `Kd xyz ...` are left alone.
void read_color(TextWords& words, std::string_view rest, glm::vec3& color)
{
    if (rest.starts_with("spectral") || rest.starts_with("xyz")) return;
    color = glm::vec3(words.number<float>());
    if (rest.find_first_of(" \t") == std::string_view::npos) return;
    color.y = words.number<float>();
    color.z = words.number<float>();
}

/// Behind options as `-s 1 1 1`: numbers and on, off.
std::string file_of(std::string_view rest)
{
    while (rest.starts_with('-')) {
        const auto skip = [&] {
            rest.remove_prefix(std::min(rest.find_first_of(" \t"), rest.size()));
            rest = trimmed(rest);
        };
        skip();
        const auto is_value = [&] {
            const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
            return word == "on" || word == "off" ||
                   (!word.empty() && word.find_first_not_of("+-.0123456789eE") == std::string_view::npos);
        };
        while (is_value()) skip();
    }
    return std::string(rest);
}

}  // namespace

void dress(Model& model, std::string_view text)
{
    std::unordered_map<std::string_view, Model::Material*> by_name;
    for (Model::Material& material : model.materials)
        if (!material.told) by_name.emplace(material.name, &material);
    Model::Material* now = nullptr;
    std::size_t line = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string_view all = text.substr(at, end - at);
        at = end + 1;
        all = trimmed(all.substr(0, std::min(all.find('#'), all.size())));
        TextWords words(all, ++line);
        const std::string_view word = words.next();
        const std::string_view rest = trimmed(all.substr(word.size()));
        if (word == "newmtl") {
            const auto known = by_name.find(rest);
            now = known == by_name.end() ? nullptr : known->second;
            if (now) now->told = true, by_name.erase(known);
        }
        if (!now) continue;
        if (word == "Kd") read_color(words, rest, now->color);
        else if (word == "Ke") read_color(words, rest, now->emission);
        else if (word == "d" && !rest.starts_with("-")) now->opacity = std::clamp(words.number<float>(), 0.0f, 1.0f);
        else if (word == "Tr") now->opacity = std::clamp(1.0f - words.number<float>(), 0.0f, 1.0f);
        else if (word == "map_Kd") now->picture_path = file_of(rest);
    }
}

}  // namespace model
