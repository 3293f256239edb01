#pragma once

#include "csg/solids/shared/outline_shape.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/// A font file as the module with FreeType reads it: few scenes have texts, and every run would wait for the library.
namespace font {

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

/// `unicode`: see font::lay_out(). Throws std::runtime_error.
using OpenFont = FontFile* (*)(const std::string& path, bool unicode);

inline constexpr const char* kFontModule = "libwhittle_fonts.so";
inline constexpr const char* kFontEntry = "whittle_fonts";

}  // namespace font
