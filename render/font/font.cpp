#include "render/font/font.h"

#include "render/font/font_file.h"
#include "render/image/codecs/module_path.h"

#include <unordered_map>

namespace font {
namespace {

FontFile* open_font(const std::string& path, const CharacterMap& map)
{
    static const auto open = reinterpret_cast<OpenFont>(image::module_entry(kFontModule, kFontEntry));
    return open(path, map);
}

}  // namespace

struct Fonts::Opened {
    Opened(const std::string& path, const CharacterMap& map) : file(open_font(path, map)), kerns(file->kerns()) {}

    /// In ems.
    struct Measured {
        double advance = 0.0, bearing = 0.0;
        std::shared_ptr<const csg::OutlineShape> outline;  ///< null: it has none
    };
    std::unique_ptr<FontFile> file;
    bool kerns;
    std::unordered_map<char16_t, std::uint32_t> codes;
    std::unordered_map<std::uint64_t, glm::dvec2> pairs;
    std::unordered_map<std::uint32_t, Measured> glyphs;

    const Measured& glyph(std::uint32_t index, std::size_t& outlines)
    {
        const auto known = glyphs.find(index);
        if (known != glyphs.end()) return known->second;
        FontFile::Measured read = file->measured(index);
        Measured made{read.advance, read.bearing, nullptr};
        if (read.drawn) {
            made.outline = std::make_shared<csg::OutlineShape>(std::move(read.pieces));
            ++outlines;
        }
        return glyphs.emplace(index, std::move(made)).first->second;
    }
    std::uint32_t index_of(char16_t code)
    {
        const auto [known, fresh] = codes.try_emplace(code, 0);
        if (fresh) known->second = file->glyph_of(code);
        return known->second;
    }
    glm::dvec2 kerning(std::uint32_t before, std::uint32_t index)
    {
        if (!kerns) return glm::dvec2(0.0);
        const auto [known, fresh] = pairs.try_emplace((std::uint64_t{before} << 32) | index, glm::dvec2(0.0));
        if (fresh) known->second = file->kerning(before, index);
        return known->second;
    }
};

Fonts::Fonts() = default;
Fonts::~Fonts() = default;

std::vector<Glyph> Fonts::lay_out(const std::string& path, const std::u16string& text, const glm::dvec2& offset,
                                  const CharacterMap& map)
{
    std::unique_ptr<Opened>& opened = opened_[{path, map}];
    if (!opened) opened = std::make_unique<Opened>(path, map);
    std::vector<Glyph> out;
    glm::dvec2 pen(0.0);
    std::uint32_t before = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::uint32_t index = opened->index_of(text[i]);
        const auto& glyph = opened->glyph(index, outlines_);
        glm::dvec2 origin = pen;
        if (i == 0) {
            origin.x = -glyph.bearing;  // its ink starts at 0
            pen.x = glyph.advance - glyph.bearing;
        } else {
            const glm::dvec2 kern = opened->kerning(before, index);
            origin += kern;
            pen.x += glyph.advance + kern.x;
        }
        pen += offset;
        before = index;
        if (text[i] == u' ' || !glyph.outline || glyph.outline->empty()) continue;
        out.push_back({glyph.outline, origin});
    }
    return out;
}

std::vector<Glyph> lay_out(const std::string& path, const std::u16string& text, const glm::dvec2& offset,
                           const CharacterMap& map)
{
    return Fonts().lay_out(path, text, offset, map);
}

}  // namespace font
