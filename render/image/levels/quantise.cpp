#include "render/image/levels/quantise.h"

#include <algorithm>

namespace image {

namespace {

constexpr int kLeastBits = 1, kMostBits = 16;  // the range of Bits_Per_Color in 3.8

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

RowQuantiser::RowQuantiser(int width, int height, const Encoding& encoding)
    : width_(width), colours_(encoding.greyscale ? 1 : 3), channels_(colours_ + (encoding.alpha ? 1 : 0)),
      bits_(std::clamp(encoding.bits, kLeastBits, kMostBits)), alpha_(encoding.alpha), greyscale_(encoding.greyscale),
      transcode_(encoding.curves.working, encoding.curves.file), curves_{&transcode_, &transcode_, &transcode_,
                                                                         &as_it_is_},
      ditherer_(encoding.dither, width, channels_, bits_)
{
    if (greyscale_) curves_[1] = &as_it_is_;  // alpha is a share of area: never gamma encoded
    // Without dithering a level depends on the sample alone. Making a table takes as long as some thousand samples.
    constexpr std::size_t kFewSamples = 1u << 14;
    const std::size_t samples = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                                static_cast<std::size_t>(channels_);
    if (encoding.dither == Dither::None && bits_ <= LevelTable::kMostBits && samples > kFewSamples)
        levels_.emplace(transcode_, bits_);
}

void RowQuantiser::round(int row, const float* pixels, std::uint16_t* out)
{
    if (levels_ && !greyscale_ && !alpha_)  // as nearly all pictures are: nothing to ask for each pixel
        return levels_->round(pixels, static_cast<std::size_t>(width_), out);
    for (int x = 0; x < width_; ++x, pixels += 4, out += channels_) {
        std::array<float, 4> pixel{pixels[0], pixels[1], pixels[2], pixels[3]};
        if (greyscale_) pixel[0] = pixel[1] = pixel[2] = luminance(pixel[0], pixel[1], pixel[2]);
        if (alpha_) make_straight(pixel.data(), pixel.data());
        if (greyscale_) pixel[1] = pixel[3];
        if (!levels_) {
            ditherer_.round(x, row, pixel.data(), curves_.data(), out);
            continue;
        }
        for (int c = 0; c < channels_; ++c)
            out[c] = c < colours_ ? (*levels_)(pixel[static_cast<std::size_t>(c)])
                                  : quantised(pixel[static_cast<std::size_t>(c)], bits_);
    }
}

Raster quantise(const Image& picture, const Encoding& encoding)
{
    RowQuantiser rounding(picture.width, picture.height, encoding);
    Raster out;
    out.width = picture.width;
    out.height = picture.height;
    out.bits = rounding.bits();
    out.channels = rounding.channels();
    out.samples.resize(picture.pixels.size() / 4 * static_cast<std::size_t>(out.channels));
    for (int row = 0; row < picture.height; ++row) {
        const int y = encoding.bottom_up ? picture.height - 1 - row : row;
        rounding.round(y, picture.at(0, y), out.at(0, y));
    }
    return out;
}

}  // namespace image
