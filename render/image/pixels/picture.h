#pragma once

#include "render/image/pixels/samples.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace image {

/// A picture could not be read or written; what() names the file.
struct FileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A picture file as read, top row first: 0 to 1 for integer files, values as stored (no gamma applied).
struct Picture {
    int width = 0, height = 0, channels = 0;
    int bits = 8;                ///< of a sample in the file, at least 8; 32 is float
    Samples samples;             ///< channels of each pixel; none where there is a palette
    float file_gamma = 0.0f;     ///< of its gAMA entry as decoding gamma; 0: none
    bool srgb = false;           ///< tagged as sRGB
    bool premultiplied = false;  ///< colours are times alpha, as in OpenEXR files and, once read, TIFFs

    /// For files with a palette the places in it, one a pixel, and its colours: red, green, blue, alpha each.
    std::vector<std::uint8_t> indices;
    std::vector<float> palette;

    std::size_t count() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
    /// The first four channels of a pixel.
    std::array<float, 4> at(int x, int y) const
    {
        const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(x);
        const auto all = static_cast<std::size_t>(channels);
        std::array<float, 4> out{};
        for (std::size_t c = 0; c < all && c < out.size(); ++c)
            out[c] = indices.empty() ? samples[pixel * all + c] : palette[4 * std::size_t{indices[pixel]} + c];
        return out;
    }
};

/// A picture whose indices and palette are set has three channels, or four if a colour is clear. Throws FileError for
/// an index beyond the palette.
void finish_palette(Picture& picture);

}  // namespace image
