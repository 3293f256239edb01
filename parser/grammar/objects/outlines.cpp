#include "parser/grammar/core/solid_reader.h"
#include "parser/stream/text.h"
#include "render/font/font.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

/// Characters as solids (reference manual: Text).
namespace parser {
namespace {

struct font_of_text : taker<font_of_text>, always {
    static bool take(TokenStream& in, ParameterState<scene::Text>& s)
    {
        if (in.accept(Kind::Internal)) {
            s.solid.internal_font = number(in);
            return true;
        }
        in.expect(Kind::Ttf, "'ttf' and a font's file, or 'internal' and a number");
        const scene::SourceRef at = in.here();
        const std::string name = path_expr(in);
        std::string& found = s.build.font_files[name];
        if (found.empty()) {
            found = in.find_file(name, {".ttf", ".TTF"});
            if (found.empty()) in.fail(at, fmt::format("cannot find the font file '{}'", name));
            in.read_files().data(found);
        }
        s.solid.font = found;
        return true;
    }
    static Form form()
    {
        return form_of<pegtl::sor<seq<token<Kind::Ttf>, a_text>, seq<token<Kind::Internal>, a_number>>>();
    }
};
/// cmap { platform, encoding }: words of POV-Ray's development after 3.8's beta.
struct cmap_of_text : taker<cmap_of_text>, always {
    static bool take(TokenStream& in, ParameterState<scene::Text>& s)
    {
        if (!in.accept(Kind::Cmap)) return true;
        const scene::SourceRef opened = s.build.open_block("cmap");
        glm::dvec2& map = s.solid.cmap.emplace();
        map.x = number(in);
        in.accept_comma();
        map.y = number(in);
        for (const double one : {map.x, map.y})
            if (!(one >= 0.0 && one < 65536.0 && one == std::floor(one)))
                s.fail("a character map is two whole numbers, a platform's and an encoding's");
        s.build.close_block("cmap", opened);
        return true;
    }
    static Form form()
    {
        return Form::optional(
            Form::sequence({Form::token(Kind::Cmap), Form::braces({form_of<seq<a_number, opt_comma, a_number>>()})}));
    }
};
using text_rule = seq<font_of_text, cmap_of_text, opt_comma,
                      values<&scene::Text::characters, &scene::Text::thickness, &scene::Text::offset>>;

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
    const font::CharacterMap map =
        text.cmap ? font::CharacterMap(static_cast<int>(text.cmap->x), static_cast<int>(text.cmap->y))
                  : font::CharacterMap(unicode);
    const auto file = font_path(s, text);
    std::vector<font::Glyph> glyphs;
    try {
        glyphs = s.build.fonts.lay_out(file, units_of(text.characters), {text.offset.x, text.offset.y}, map);
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

Form parameters_form(const SolidReader*, const scene::Text*, Kind) { return form_of<text_rule>(); }

bool read_parameters(SolidReader& s, scene::Text& text)
{
    read_solid<text_rule>(s, text);
    s.object().shape = shape_of(s, text);
    // POV-Ray turns every text by this much, visible in its normals and extents (spec 5b, 11).
    s.object().transform_by(csg::Transform::rotate_degrees(glm::dvec3(0.001)));
    return true;
}

}  // namespace parser
