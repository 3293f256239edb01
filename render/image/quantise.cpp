#include "render/image/quantise.h"

#include "render/image/level_table.h"

#include <algorithm>
#include <array>
#include <optional>

namespace image {

namespace {

constexpr int kLeastBits = 5, kMostBits = 16;  // the range of Bits_Per_Color

/// POV-Ray divides the colour of a wholly clear pixel by this in place of 0.
constexpr float kClearDivisor = 1e-6f;

}  // namespace

std::uint16_t quantised(float x, int bits)
{
    const auto largest = static_cast<float>((1 << bits) - 1);
    if (!(x > 0.0f)) return 0;  // NaN fails every comparison
    if (x >= 1.0f) return static_cast<std::uint16_t>(largest);
    return static_cast<std::uint16_t>(x * largest + 0.5f);  // cut off, which is the floor above 0
}

void make_straight(const float weighted[4], float straight[4])
{
    const float alpha_given = 1.0f - weighted[3];
    const float bright = luminance(weighted[0], weighted[1], weighted[2]);
    const float alpha = bright > alpha_given ? std::min(1.0f, bright) : alpha_given;
    const float divisor = alpha == 0.0f ? kClearDivisor : alpha;
    for (int c = 0; c < 3; ++c) straight[c] = weighted[c] / divisor;
    straight[3] = alpha;
}

Raster quantise(const Image& picture, const Encoding& encoding)
{
    const Transcoder transcode(encoding.curves.working, encoding.curves.file), as_it_is;
    Raster out;
    out.width = picture.width;
    out.height = picture.height;
    out.bits = std::clamp(encoding.bits, kLeastBits, kMostBits);
    const int colours = encoding.greyscale ? 1 : 3;
    out.channels = colours + (encoding.alpha ? 1 : 0);
    out.samples.resize(picture.pixels.size() / 4 * static_cast<std::size_t>(out.channels));
    std::array<const Transcoder*, kMostChannels> curves{&transcode, &transcode, &transcode, &as_it_is};
    if (encoding.greyscale) curves[1] = &as_it_is;  // alpha is a share of area: never gamma encoded
    // Without dithering a level depends on the sample alone. Making a table takes as long as some thousand samples.
    constexpr std::size_t kFewSamples = 1u << 14;
    std::optional<LevelTable> levels;
    if (encoding.dither == Dither::None && out.bits <= LevelTable::kMostBits && out.samples.size() > kFewSamples) levels.emplace(transcode, out.bits);
    Ditherer ditherer(encoding.dither, picture.width, out.channels, out.bits);
    for (int row = 0; row < picture.height; ++row) {
        const int y = encoding.bottom_up ? picture.height - 1 - row : row;
        for (int x = 0; x < picture.width; ++x) {
            const float* from = picture.at(x, y);
            std::array<float, 4> pixel{from[0], from[1], from[2], from[3]};
            if (encoding.greyscale) pixel[0] = pixel[1] = pixel[2] = luminance(pixel[0], pixel[1], pixel[2]);
            if (encoding.alpha) make_straight(pixel.data(), pixel.data());
            if (encoding.greyscale) pixel[1] = pixel[3];
            std::uint16_t* to = out.at(x, y);
            if (!levels) {
                ditherer.round(x, y, pixel.data(), curves.data(), to);
                continue;
            }
            for (int c = 0; c < out.channels; ++c)
                to[c] = c < colours ? (*levels)(pixel[static_cast<std::size_t>(c)]) : quantised(pixel[static_cast<std::size_t>(c)], out.bits);
        }
    }
    return out;
}

}  // namespace image
