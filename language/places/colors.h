#pragma once

#include "language/names/document.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace language {

/// A colour of numbers alone, as in `rgb <1, 0.5, 0>` or `srgbt <1, 1, 0, 0.5>`.
struct Swatch {
    Range range;                    ///< from the word to the last number
    std::string word;               ///< "rgb", "srgbft", ...
    std::array<double, 5> value{};  ///< red, green, blue, filter, transmit as written
    bool linear = true;             ///< linear light; false: encoded for a screen (sRGB)
};

/// All colours of the text that are made of numbers alone. `linear_light`: linear_light() of the scene, for `rgb`.
std::vector<Swatch> swatches_of(const Document& document, bool linear_light);

/// Whether `rgb` in a text means linear light: with `assumed_gamma 1`, and without any assumed_gamma from
/// `#version 3.7` on.
bool linear_light(const Document& document);

/// Red, green and blue encoded for a screen (sRGB), and opacity, each from 0 to 1.
std::array<double, 4> screen_color(const Swatch& swatch);

/// The text that puts another colour (as screen_color() gives it) in the place of a swatch. Its word stays unless the
/// colour needs another one.
std::string color_text(const Swatch& swatch, const std::array<double, 4>& screen);

}  // namespace language
