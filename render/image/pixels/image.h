#pragma once

#include "render/image/pixels/page_allocator.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace image {

/// What the tracer hands over: one r, g, b, transmit (0 opaque, 1 clear) per pixel, top row first, single precision.
/// Colours are in the scene's working space (linear unless assumed_gamma says otherwise), unclamped, and already
/// weighted by their opacity: a clear pixel in front of nothing is 0, 0, 0, 1.
struct Image {
    int width = 0, height = 0;
    std::vector<float, PageAllocator<float>> pixels;  ///< 4 * width for each row that is here
    int top = 0;  ///< the first row that is here; all rows are unless the picture is made in strips

    /// Rows [first, first + count), black and opaque, in place of what was here. Small pages are for a picture of which
    /// few blocks are made.
    void hold(int first, int count, Pages pages = Pages::large)
    {
        top = first;
        pixels = decltype(pixels)(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(count),
                                  PageAllocator<float>(pages));
    }
    /// Of the whole picture's pixel.
    float* at(int x, int y)
    {
        return &pixels[4 * (static_cast<std::size_t>(y - top) * static_cast<std::size_t>(width) +
                            static_cast<std::size_t>(x))];
    }
    const float* at(int x, int y) const { return const_cast<Image*>(this)->at(x, y); }
};

/// What a picture file holds: integers of `bits` bits, channels interleaved, top row first.
/// 1 channel: grey; 2: grey, alpha; 3: red, green, blue; 4: with straight alpha.
struct Raster {
    int width = 0, height = 0, channels = 3;
    int bits = 8;                        ///< 5 to 16: the largest value is 2^bits - 1
    std::vector<std::uint16_t> samples;  ///< channels * width * height

    std::uint16_t* at(int x, int y)
    {
        return &samples[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
                        static_cast<std::size_t>(channels)];
    }
    const std::uint16_t* at(int x, int y) const { return const_cast<Raster*>(this)->at(x, y); }
    int maximum() const { return (1 << bits) - 1; }
};

}  // namespace image
