#pragma once

#include "render/plan/compiled_scene.h"
#include "render/scene/description.h"

#include <cctype>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace explain {

/// Things of a scene by the word and the place where they stand in its text.
class PlaceNames {
public:
    explicit PlaceNames(const scene::Description& description) : description_(description) {}

    /// "sphere scene.pov:12:1"
    std::string solid(const scene::SourceRef& source)
    {
        const scene::Place place = description_.place(source);
        return place.path.empty() ? "solid" : word_at(place) + " " + scene::place_text(place);
    }
    std::string solid(const plan::CompiledScene& scene, const plan::Surface& surface)
    {
        return solid(surface.object < scene.objects.size() ? scene.objects[surface.object].source : scene::SourceRef());
    }
    /// "the object of scene.pov:12:1"
    std::string object(const plan::CompiledScene& scene, csg::SurfaceId surface) const
    {
        const std::uint32_t number = scene.surfaces[surface].object;
        if (number >= scene.objects.size()) return "an object";
        const std::string place = scene::place_text(description_.place(scene.objects[number].source));
        return place.empty() ? "an object" : "the object of " + place;
    }

private:
    /// The word that stands at a place: "sphere", "object", a macro's name.
    std::string word_at(const scene::Place& place)
    {
        auto known = lines_.find(place.path);
        if (known == lines_.end()) {
            std::ifstream in(place.path);
            std::vector<std::string> lines;
            for (std::string text; std::getline(in, text);) lines.push_back(text);
            known = lines_.emplace(place.path, std::move(lines)).first;
        }
        if (place.at.line == 0 || place.at.line > known->second.size()) return "solid";
        const std::string& text = known->second[place.at.line - 1];
        std::size_t begin = place.at.column - 1, end = begin;
        while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_')) ++end;
        return end > begin ? text.substr(begin, end - begin) : "solid";
    }

    const scene::Description& description_;
    std::map<std::string, std::vector<std::string>> lines_;
};

}  // namespace explain
