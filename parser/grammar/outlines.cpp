#include "parser/grammar/shape_makers.h"
#include "parser/stream/text.h"
#include "render/font/font.h"

#include <algorithm>
#include <stdexcept>

/// Characters as solids (reference manual: Text).
namespace parser {
namespace {

using scene::StatementItem;

/// POV-Ray's own faces are files of the package (spec 5b, 11).
std::string font_path(SceneBuilder& build, const scene::Statement& statement)
{
    if (const StatementItem* file = item_of(statement, "ttf")) return std::get<std::string>(file->operands[0]);
    static constexpr const char* kFaces[] = {"povlogo.ttf", "timrom.ttf", "cyrvetic.ttf", "crystal.ttf"};
    const double number = number_of(item_of(statement, "internal")->operands[0]);
    const char* const name = kFaces[number >= 1.0 && number < 4.0 ? static_cast<int>(number) : 0];
    const std::string path = build.stream().find_file(name, {});
    if (path.empty()) build.stream().fail(statement.source, std::string("cannot find the font file '") + name + "'");
    return path;
}

}  // namespace

bool make_text(SceneBuilder& build, const scene::Statement& statement, scene::Object& object)
{
    const auto& operands = item_of(statement, "")->operands;
    const double thickness = number_of(operands[1]);
    const glm::dvec3 offset = std::get<glm::dvec3>(operands[2]);
    const bool unicode = build.stream().language().charset != Charset::Ascii;
    const auto file = font_path(build, statement);
    std::vector<font::Glyph> glyphs;
    try {
        glyphs = font::lay_out(file, units_of(std::get<std::string>(operands[0])), {offset.x, offset.y}, unicode);
    } catch (const std::runtime_error& error) {
        build.stream().fail(statement.source, error.what());
    }
    auto characters = std::make_shared<std::vector<scene::Object>>();
    for (const font::Glyph& glyph : glyphs) {
        scene::Object character;
        character.source = statement.source;
        character.shape = scene::Extrusion{glyph.outline, std::min(0.0, thickness), std::max(0.0, thickness), false, false, false};
        character.transform = csg::Transform::translate({glyph.origin, 0.0});
        characters->push_back(std::move(character));
    }
    scene::Csg all;
    all.operands = std::move(characters);
    object.shape = all;
    // POV-Ray turns every text by this much, visible in its normals and extents (spec 5b, 11).
    object.transform = csg::Transform::rotate_degrees(glm::dvec3(0.001));
    return true;
}

}  // namespace parser
