#pragma once

#include "csg/solids/shared/outline_shape.h"
#include "render/font/font_file.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace font {

/// A character of a text: its region, one em a unit, and where its origin lies.
struct Glyph {
    std::shared_ptr<const csg::OutlineShape> outline;  ///< characters that are alike share it
    glm::dvec2 origin{0.0};
};

/// Fonts that are asked again and again: files are opened, and outlines made, once.
class Fonts {
public:
    Fonts();
    ~Fonts();
    Fonts(const Fonts&) = delete;
    Fonts& operator=(const Fonts&) = delete;

    /// The same as font::lay_out().
    std::vector<Glyph> lay_out(const std::string& path, const std::u16string& text, const glm::dvec2& offset,
                               const CharacterMap& map);
    /// Outlines made so far.
    std::size_t outlines() const { return outlines_; }

private:
    struct Opened;
    std::map<std::pair<std::string, CharacterMap>, std::unique_ptr<Opened>> opened_;  ///< by path and table
    std::size_t outlines_ = 0;
};

/// The characters of a text that have an outline, in its order (spec 5b, 11.1 to 11.3). `offset` is added behind every
/// character. Throws std::runtime_error where the file is no font that can be read, or has no such table.
std::vector<Glyph> lay_out(const std::string& path, const std::u16string& text, const glm::dvec2& offset,
                           const CharacterMap& map);

}  // namespace font
