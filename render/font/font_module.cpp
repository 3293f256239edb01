#include "render/font/font_file.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_TRUETYPE_TABLES_H

#include <array>
#include <stdexcept>
#include <string>

namespace {

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

class Face final : public font::FontFile {
public:
    Face(const std::string& path, const font::CharacterMap& map)
    {
        if (FT_New_Face(library_.get(), path.c_str(), 0, &face_) != 0 ||
            (face_->face_flags & FT_FACE_FLAG_SCALABLE) == 0) {
            if (face_ != nullptr) FT_Done_Face(face_);
            throw std::runtime_error("this is no TrueType font");
        }
        if (map.platform >= 0) choose_table(map.platform, map.encoding);
        else choose_codes(map.unicode ? std::array{0, 3, 1, 3} : std::array{1, 3, 0, 3});
    }
    ~Face() override { FT_Done_Face(face_); }
    Face(const Face&) = delete;
    Face& operator=(const Face&) = delete;

    std::uint32_t glyph_of(char16_t code) const override
    {
        constexpr FT_ULong kSymbols = 0xF000;
        const FT_UInt found = FT_Get_Char_Index(face_, code);
        return found == 0 && wide_ && code < 256 ? FT_Get_Char_Index(face_, kSymbols + code) : found;
    }
    Measured measured(std::uint32_t glyph) const override
    {
        if (FT_Load_Glyph(face_, glyph, FT_LOAD_NO_SCALE) != 0)
            throw std::runtime_error("a character of this font is broken");
        const FT_GlyphSlot slot = face_->glyph;
        Measured made{scale() * static_cast<double>(slot->metrics.horiAdvance),
                      scale() * static_cast<double>(slot->metrics.horiBearingX),
                      slot->format == FT_GLYPH_FORMAT_OUTLINE,
                      {}};
        int first = 0;
        for (int c = 0; made.drawn && c < slot->outline.n_contours; ++c) {
            const int last = slot->outline.contours[c];
            if (last > first) add_contour(slot->outline, first, last, scale(), made.pieces);
            first = last + 1;
        }
        return made;
    }
    bool kerns() const override { return FT_HAS_KERNING(face_); }
    glm::dvec2 kerning(std::uint32_t before, std::uint32_t glyph) const override
    {
        FT_Vector kern{0, 0};
        FT_Get_Kerning(face_, before, glyph, FT_KERNING_UNSCALED, &kern);
        return {scale() * static_cast<double>(kern.x), scale() * static_cast<double>(kern.y)};
    }

private:
    double scale() const { return 1.0 / static_cast<double>(face_->units_per_EM); }

    /// The table of codes: the first of the platforms, in this order, whose form POV-Ray reads.
    void choose_table(int platform, int encoding)
    {
        for (int i = 0; i < face_->num_charmaps; ++i) {
            const FT_CharMap map = face_->charmaps[i];
            if (map->platform_id != platform || map->encoding_id != encoding) continue;
            wide_ = FT_Get_CMap_Format(map) == 4;
            FT_Set_Charmap(face_, map);
            return;
        }
        FT_Done_Face(face_);
        throw std::runtime_error("this font has no character map { " + std::to_string(platform) + ", " +
                                 std::to_string(encoding) + " }");
    }
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

    Library library_;
    FT_Face face_ = nullptr;
    bool wide_ = false;
};

}  // namespace

extern "C" __attribute__((visibility("default"))) font::FontFile* whittle_fonts(const std::string& path,
                                                                                const font::CharacterMap& map)
{
    return new Face(path, map);
}
