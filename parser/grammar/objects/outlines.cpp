#include "parser/grammar/core/solid_reader.h"
#include "parser/stream/text.h"
#include "render/font/font.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

/// Characters as solids (reference manual: Text).
namespace parser {
namespace {

void read_font(SolidReader& s, scene::Text& text)
{
    if (s.accept(Kind::Ttf)) {
        const scene::SourceRef at = s.in().here();
        const std::string name = path_expr(s.in());
        std::string& found = s.build().font_files[name];
        if (found.empty()) {
            found = s.in().find_file(name, {".ttf", ".TTF"});
            if (found.empty()) s.in().fail(at, fmt::format("cannot find the font file '{}'", name));
            s.in().data_files().push_back(found);
        }
        text.font = found;
    } else if (s.accept(Kind::Internal)) {
        text.internal_font = float_expr(s.in());
    } else {
        s.in().fail_expected("'ttf' and a font's file, or 'internal' and a number");
    }
}

/// POV-Ray's own faces are files of the package (spec 5b, 11).
std::string font_path(SolidReader& s, const scene::Text& text)
{
    if (!text.font.empty()) return text.font;
    static constexpr const char* kFaces[] = {"povlogo.ttf", "timrom.ttf", "cyrvetic.ttf", "crystal.ttf"};
    const double number = text.internal_font;
    const char* const name = kFaces[number >= 1.0 && number < 4.0 ? static_cast<int>(number) : 0];
    const std::string path = s.in().find_file(name, {});
    if (path.empty()) s.in().fail(s.source(), std::string("cannot find the font file '") + name + "'");
    return path;
}

scene::Csg shape_of(SolidReader& s, const scene::Text& text)
{
    const bool unicode = s.in().language().charset != Charset::Ascii;
    const auto file = font_path(s, text);
    std::vector<font::Glyph> glyphs;
    try {
        glyphs = s.build().fonts.lay_out(file, units_of(text.characters), {text.offset.x, text.offset.y}, unicode);
    } catch (const std::runtime_error& error) {
        s.in().fail(s.source(), error.what());
    }
    auto characters = std::make_shared<std::vector<scene::Object>>();
    characters->reserve(glyphs.size());
    for (const font::Glyph& glyph : glyphs) {
        scene::Object character;
        character.source = s.source();
        character.shape = scene::Extrusion{
            glyph.outline, std::min(0.0, text.thickness), std::max(0.0, text.thickness), false, false, false};
        character.transform = csg::Transform::translate({glyph.origin, 0.0});
        characters->push_back(std::move(character));
    }
    scene::Csg all;
    all.operands = std::move(characters);
    return all;
}

}  // namespace

bool read_parameters(SolidReader& s, scene::Text& text)
{
    read_font(s, text);
    s.in().accept_comma();
    read_values(s.in(), text.characters, text.thickness, text.offset);
    s.object().shape = shape_of(s, text);
    // POV-Ray turns every text by this much, visible in its normals and extents (spec 5b, 11).
    s.object().transform_by(csg::Transform::rotate_degrees(glm::dvec3(0.001)));
    return true;
}

}  // namespace parser
