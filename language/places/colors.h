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
    bool linear = true;             ///< light, else as screens take it
};

/// `linear_light`: what `rgb` means (linear_light() of the scene).
std::vector<Swatch> swatches_of(const Document& document, bool linear_light);

/// Whether `rgb` of a text is linear light: so it is with `assumed_gamma 1`, and from `#version 3.7` on without any.
bool linear_light(const Document& document);

/// Red, green, blue as a screen takes them and how opaque it is, each from 0 to 1.
std::array<double, 4> screen_color(const Swatch& swatch);

/// The text for another colour in the place of a swatch: its word stays where it can.
std::string color_text(const Swatch& swatch, const std::array<double, 4>& screen);

}  // namespace language
