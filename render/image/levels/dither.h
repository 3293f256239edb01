#pragma once

#include "render/image/levels/transfer_curve.h"

#include <array>
#include <cstdint>
#include <vector>

namespace image {

inline constexpr std::size_t kMostChannels = 4;

/// How what rounding loses is given to neighbours (reference manual 3.2.2.6.5; spec 2, 12.5). Ordered: a pattern of
/// 2x2, 3x3 or 4x4 pixels. Carry: all of an error goes to the next pixel. Spread: to right, below and below right.
/// From Bayer2 on as POV-Ray 3.8 has them (spec 7, 3.3): patterns choose by the share of light between two levels,
/// errors are what is missing of the light, and of two levels the nearer in light is taken.
enum class Dither {
    None,
    Ordered2,
    Ordered3,
    Ordered4,
    Carry,
    Spread,
    FloydSteinberg,
    Bayer2,
    Bayer3,
    Bayer4,
    BlueNoise,           ///< a pattern of 64x64 pixels without low frequencies
    BlueNoiseExchanged,  ///< the same, turned over for red and blue
    SierraLite,
    FloydSteinbergLight,
    Atkinson,
    Burkes,
    JarvisJudiceNinke,
    SierraTwoRows,
    SierraThreeRows,
    Stucki,
    kLast = Stucki
};

/// Rounds the samples of a picture, pixel after pixel in the order of the file.
class Ditherer {
public:
    Ditherer(Dither kind, int width, int channels, int bits);

    /// \param levels  of the channels, working space
    /// \param curves  of the channels
    /// \param out  as many integers
    void round(int x, int y, const float* levels, const Transcoder* const* curves, std::uint16_t* out);

private:
    std::uint16_t with_pattern(int x, int y, float level, const Transcoder& curve) const;
    std::uint16_t with_error(float wanted, const Transcoder& curve, float& error) const;
    void spread(int x, int channel, float error);
    void round_by_light(int x, int y, const float* levels, const Transcoder* const* curves, std::uint16_t* out);
    float& carried(std::vector<float>& row, int x, int channel)
    {
        return row[static_cast<std::size_t>(x * channels_ + channel)];
    }

    Dither kind_;
    int width_, channels_, bits_;
    std::vector<float> this_row_, next_row_;  ///< errors carried to a pixel, working space
    std::vector<float> next_pixel_;           ///< Carry: by channel
    std::vector<float> third_row_;            ///< of those of 3.8: errors carried two rows down
    int row_ = 0;                             ///< of those of 3.8: that this_row_ belongs to
};

}  // namespace image
