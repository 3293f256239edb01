#pragma once

#include "render/scene/base/dump_writer.h"

#include <optional>
#include <string>

namespace scene {

/// Characters of a font, swept along z (reference manual: Text).
struct Text {
    static constexpr std::string_view kKeywords[] = {"text"};

    std::string font;                ///< file; empty: one that comes with POV-Ray
    double internal_font = 1.0;      ///< which of those, as written
    std::optional<glm::dvec2> cmap;  ///< platform and encoding of the font's table of characters, whole numbers
    std::string characters;
    double thickness = 1.0;  ///< along z, either way
    glm::dvec3 offset{0.0};  ///< between one character and the next, beside what the font asks for

    void dump(DumpWriter& out) const
    {
        if (font.empty()) out.words("internal", internal_font);
        else out.words("ttf", font);
        if (cmap) out.words("cmap", cmap->x, cmap->y);
        out.words("-", characters, thickness, offset);
    }
};

}  // namespace scene
