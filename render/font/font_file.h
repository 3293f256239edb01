#pragma once

#include "csg/solids/shared/outline_shape.h"

#include <compare>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/// A font file as the module with FreeType reads it: few scenes have texts, and every run would wait for the library.
namespace font {

/// The table of a font in which codes are looked up: its Unicode one first, else the Macintosh one, or the other way
/// round; or the one of a platform and an encoding, which the font must have then.
struct CharacterMap {
    CharacterMap(bool first_unicode) : unicode(first_unicode) {}
    CharacterMap(int of_platform, int of_encoding) : platform(of_platform), encoding(of_encoding) {}

    bool unicode = false;
    int platform = -1, encoding = -1;  ///< as the file numbers them; -1: not chosen
    auto operator<=>(const CharacterMap&) const = default;
};

class FontFile {
public:
    virtual ~FontFile() = default;
    /// 0, the sign for what is missing, where there is none.
    virtual std::uint32_t glyph_of(char16_t code) const = 0;

    /// In ems.
    struct Measured {
        double advance = 0.0, bearing = 0.0;
        bool drawn = false;  ///< it has an outline, empty or not
        std::vector<csg::OutlinePiece> pieces;
    };
    virtual Measured measured(std::uint32_t glyph) const = 0;
    virtual bool kerns() const = 0;
    virtual glm::dvec2 kerning(std::uint32_t before, std::uint32_t glyph) const = 0;  ///< in ems
};

/// Throws std::runtime_error.
using OpenFont = FontFile* (*)(const std::string& path, const CharacterMap& map);

inline constexpr const char* kFontModule = "libwhittle_fonts.so";
inline constexpr const char* kFontEntry = "whittle_fonts";

}  // namespace font
