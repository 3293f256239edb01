#pragma once

#include "render/image/levels/dither.h"
#include "render/image/pixels/image.h"
#include "render/image/levels/level_table.h"
#include "render/image/levels/transfer_curve.h"

#include <array>
#include <optional>

namespace image {

/// How float pixels become integers (spec 2, 12).
struct Encoding {
    OutputCurves curves;
    int bits = 8;            ///< per channel, clamped to 1..16
    bool alpha = false;      ///< straight alpha as the last channel; without it the picture stands before black
    bool greyscale = false;  ///< one channel of luminance
    Dither dither = Dither::None;
    bool bottom_up = false;  ///< rows are rounded in this order: dithering carries errors along
};

/// floor(clamp(x, 0, 1) * (2^bits - 1) + 0.5) in single precision; a NaN becomes 0.
std::uint16_t quantised(float x, int bits);

/// Luminance with POV-Ray's weights.
inline float luminance(float red, float green, float blue) { return 0.297f * red + 0.589f * green + 0.114f * blue; }

/// Straight colour and alpha of a pixel weighted by its opacity, r, g, b, transmit in and r, g, b, alpha out: pixels
/// brighter than their alpha become more opaque, a clear one is divided by 1e-6 (spec 2, 12.1).
void make_straight(const float weighted[4], float straight[4]);

/// Rounds a picture row after row, in the order of the file: dithering carries errors along.
class RowQuantiser {
public:
    /// \param height of the picture: where there is much to round, tables are worth their making
    RowQuantiser(int width, int height, const Encoding& encoding);
    RowQuantiser(const RowQuantiser&) = delete;
    RowQuantiser& operator=(const RowQuantiser&) = delete;
    int channels() const { return channels_; }
    int bits() const { return bits_; }
    /// \param row  its number, from the top
    /// \param pixels  4 * width, as Image has them
    /// \param out  channels * width
    void round(int row, const float* pixels, std::uint16_t* out);

private:
    int width_, colours_, channels_, bits_;
    bool alpha_, greyscale_;
    Transcoder transcode_, as_it_is_;
    std::array<const Transcoder*, kMostChannels> curves_;
    std::optional<LevelTable> levels_;
    Ditherer ditherer_;
};

/// The file's integers. The result does not depend on how many threads traced the picture.
Raster quantise(const Image& picture, const Encoding& encoding);

}  // namespace image
