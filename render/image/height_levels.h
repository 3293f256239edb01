#pragma once

#include "render/image/levels/transfer_curve.h"

#include <cstdint>
#include <string>
#include <vector>

namespace image {

/// A picture as heights, top row first.
struct HeightLevels {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint16_t> levels;
};

/// POV-Ray's rules for the kinds of picture (spec 5b, 10.1). `decode`: of the stored levels, none unless the scene
/// asks.
/// `.pot` files hold high bytes in the left half of a GIF and low bytes in the right. Throws FileError.
HeightLevels read_heights(const std::string& path, const TransferCurve& decode);

/// The level of a colour of 16 bits a channel.
std::uint16_t color_level(std::uint16_t red, std::uint16_t green, std::uint16_t blue);

}  // namespace image
