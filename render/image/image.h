#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace image {

/// Linear, not premultiplied, single precision, top row first: r, g, b, and transmit (0 opaque, 1 clear).
struct Image {
    int width = 0, height = 0;
    std::vector<float> pixels;  ///< 4 * width * height
    float* at(int x, int y) { return &pixels[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x))]; }
    const float* at(int x, int y) const { return const_cast<Image*>(this)->at(x, y); }
};

}  // namespace image
