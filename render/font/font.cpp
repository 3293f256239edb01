#include "render/font/font.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_TRUETYPE_TABLES_H

#include <array>
#include <stdexcept>
#include <unordered_map>

namespace font {

class Library {
public:
    Library()
    {
        if (FT_Init_FreeType(&library_) != 0) throw std::runtime_error("the font library does not start");
    }
    ~Library() { FT_Done_FreeType(library_); }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
    FT_Library get() const { return library_; }

private:
    FT_Library library_ = nullptr;
};

class Face {
public:
    Face(const Library& library, const std::string& path)
    {
        if (FT_New_Face(library.get(), path.c_str(), 0, &face_) != 0 ||
            (face_->face_flags & FT_FACE_FLAG_SCALABLE) == 0) {
            if (face_ != nullptr) FT_Done_Face(face_);
            throw std::runtime_error("this is no TrueType font");
        }
    }
    ~Face() { FT_Done_Face(face_); }
    Face(const Face&) = delete;
    Face& operator=(const Face&) = delete;
    FT_Face get() const { return face_; }
    double scale() const { return 1.0 / static_cast<double>(face_->units_per_EM); }

    /// The table of codes: the first of the platforms, in this order, whose form POV-Ray reads.
    void choose_codes(const std::array<int, 4>& platforms)
    {
        for (const int platform : platforms)
            for (int i = 0; i < face_->num_charmaps; ++i) {
                const FT_CharMap map = face_->charmaps[i];
                const FT_Long format = FT_Get_CMap_Format(map);
                if (map->platform_id != platform || (format != 0 && format != 4 && format != 6)) continue;
                wide_ = format == 4;
                FT_Set_Charmap(face_, map);
                return;
            }
    }
    /// 0, the sign for what is missing, where there is none.
    FT_UInt glyph_of(char16_t code) const
    {
        constexpr FT_ULong kSymbols = 0xF000;
        const FT_UInt found = FT_Get_Char_Index(face_, code);
        return found == 0 && wide_ && code < 256 ? FT_Get_Char_Index(face_, kSymbols + code) : found;
    }

private:
    FT_Face face_ = nullptr;
    bool wide_ = false;
};

namespace {

/// One contour; its first point counts as one on the curve.
void add_contour(const FT_Outline& outline, int first, int last, double scale, std::vector<csg::OutlinePiece>& pieces)
{
    const auto point = [&](int i) {
        return scale * glm::dvec2(static_cast<double>(outline.points[i].x), static_cast<double>(outline.points[i].y));
    };
    const glm::dvec2 start = point(first);
    glm::dvec2 at = start, control(0.0);
    bool bent = false;
    const auto to = [&](const glm::dvec2& end) {
        if (bent) pieces.push_back(csg::OutlinePiece::quadratic(at, control, end));
        else if (end != at) pieces.push_back(csg::OutlinePiece::line(at, end));
        at = end;
        bent = false;
    };
    for (int i = first + 1; i <= last; ++i) {
        const glm::dvec2 p = point(i);
        if ((outline.tags[i] & 1) != 0) {
            to(p);
        } else {
            if (bent) to(0.5 * (control + p));
            control = p;
            bent = true;
        }
    }
    to(start);
}

std::shared_ptr<const csg::OutlineShape> make_outline(const FT_Outline& written, double scale)
{
    std::vector<csg::OutlinePiece> pieces;
    int first = 0;
    for (int c = 0; c < written.n_contours; ++c) {
        const int last = written.contours[c];
        if (last > first) add_contour(written, first, last, scale, pieces);
        first = last + 1;
    }
    return std::make_shared<csg::OutlineShape>(std::move(pieces));
}

}  // namespace

struct Fonts::Opened {
    Opened(const Library& library, const std::string& path, bool unicode) : face(library, path)
    {
        face.choose_codes(unicode ? std::array{0, 3, 1, 3} : std::array{1, 3, 0, 3});
        kerns = FT_HAS_KERNING(face.get());
    }
    /// In ems.
    struct Measured {
        double advance = 0.0, bearing = 0.0;
        std::shared_ptr<const csg::OutlineShape> outline;  ///< null: it has none
    };
    Face face;
    bool kerns = false;
    std::unordered_map<char16_t, FT_UInt> codes;
    std::unordered_map<std::uint64_t, glm::dvec2> pairs;
    std::unordered_map<FT_UInt, Measured> glyphs;

    const Measured& glyph(FT_UInt index, std::size_t& outlines)
    {
        const auto known = glyphs.find(index);
        if (known != glyphs.end()) return known->second;
        if (FT_Load_Glyph(face.get(), index, FT_LOAD_NO_SCALE) != 0)
            throw std::runtime_error("a character of this font is broken");
        const FT_GlyphSlot slot = face.get()->glyph;
        const double scale = face.scale();
        Measured made{scale * static_cast<double>(slot->metrics.horiAdvance),
                      scale * static_cast<double>(slot->metrics.horiBearingX), nullptr};
        if (slot->format == FT_GLYPH_FORMAT_OUTLINE) {
            made.outline = make_outline(slot->outline, scale);
            ++outlines;
        }
        return glyphs.emplace(index, std::move(made)).first->second;
    }
    FT_UInt index_of(char16_t code)
    {
        const auto [known, fresh] = codes.try_emplace(code, 0);
        if (fresh) known->second = face.glyph_of(code);
        return known->second;
    }
    glm::dvec2 kerning(FT_UInt before, FT_UInt index)
    {
        if (!kerns) return glm::dvec2(0.0);
        const auto [known, fresh] = pairs.try_emplace((std::uint64_t{before} << 32) | index, glm::dvec2(0.0));
        if (fresh) {
            FT_Vector kern{0, 0};
            FT_Get_Kerning(face.get(), before, index, FT_KERNING_UNSCALED, &kern);
            known->second = {face.scale() * static_cast<double>(kern.x), face.scale() * static_cast<double>(kern.y)};
        }
        return known->second;
    }
};

Fonts::Fonts() = default;
Fonts::~Fonts() = default;

std::vector<Glyph> Fonts::lay_out(const std::string& path, const std::u16string& text, const glm::dvec2& offset,
                                  bool unicode)
{
    if (!library_) library_ = std::make_unique<Library>();
    std::unique_ptr<Opened>& opened = opened_[{path, unicode}];
    if (!opened) opened = std::make_unique<Opened>(*library_, path, unicode);
    std::vector<Glyph> out;
    glm::dvec2 pen(0.0);
    FT_UInt before = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const FT_UInt index = opened->index_of(text[i]);
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

std::vector<Glyph> lay_out(const std::string& path, const std::u16string& text, const glm::dvec2& offset, bool unicode)
{
    return Fonts().lay_out(path, text, offset, unicode);
}

}  // namespace font
