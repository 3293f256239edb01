#include "render/image/levels/dither.h"

#include "render/image/levels/quantise.h"

#include <algorithm>
#include <utility>

namespace image {

namespace {

/// Places of the pattern in the order in which they light up, from 1.
constexpr int kPattern2[2][2] = {{1, 3}, {4, 2}};
constexpr int kPattern3[3][3] = {{3, 7, 4}, {6, 1, 9}, {2, 8, 5}};
constexpr int kPattern4[4][4] = {{1, 9, 3, 11}, {13, 5, 15, 7}, {4, 12, 2, 10}, {16, 8, 14, 6}};

/// In (-0.5, 0.5].
template <int N>
float offset(const int (&pattern)[N][N], int x, int y)
{
    return static_cast<float>(pattern[x % N][y % N]) / static_cast<float>(N * N) - 0.5f;
}

}  // namespace

Ditherer::Ditherer(Dither kind, int width, int channels, int bits)
    : kind_(kind), width_(width), channels_(channels), bits_(bits)
{
    const auto row = static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
    this_row_.resize(row);
    next_row_.resize(row);
    next_pixel_.resize(static_cast<std::size_t>(channels));
    if (kind >= Dither::Bayer2) third_row_.resize(row);
}

std::uint16_t Ditherer::with_pattern(int x, int y, float level, const Transcoder& curve) const
{
    const float q = kind_ == Dither::Ordered2   ? offset(kPattern2, x, y)
                    : kind_ == Dither::Ordered3 ? offset(kPattern3, x, y)
                                                : offset(kPattern4, x, y);
    return quantised(curve.to_file(level) + q / static_cast<float>((1 << bits_) - 1), bits_);
}

void Ditherer::spread(int x, int channel, float error)
{
    const bool last = x + 1 == width_;
    if (kind_ == Dither::Spread) {
        if (!last) carried(this_row_, x + 1, channel) += error * 0.5f;
        carried(next_row_, x, channel) += error * 0.25f;
        if (!last) carried(next_row_, x + 1, channel) += error * 0.25f;
        return;
    }
    if (!last) carried(this_row_, x + 1, channel) += error * (7.0f / 16.0f);
    if (x > 0) carried(next_row_, x - 1, channel) += error * (3.0f / 16.0f);
    carried(next_row_, x, channel) += error * (5.0f / 16.0f);
    if (!last) carried(next_row_, x + 1, channel) += error * (1.0f / 16.0f);
}

std::uint16_t Ditherer::with_error(float wanted, const Transcoder& curve, float& error) const
{
    const std::uint16_t value = quantised(curve.to_file(wanted), bits_);
    error = std::clamp(wanted, 0.0f, 1.0f) -
            curve.to_working(static_cast<float>(value) / static_cast<float>((1 << bits_) - 1));
    return value;
}

void Ditherer::round(int x, int y, const float* levels, const Transcoder* const* curves, std::uint16_t* out)
{
    const auto count = static_cast<std::size_t>(channels_);
    if (kind_ == Dither::None) {
        for (std::size_t c = 0; c < count; ++c) out[c] = quantised(curves[c]->to_file(levels[c]), bits_);
        return;
    }
    if (kind_ >= Dither::Bayer2) return round_by_light(x, y, levels, curves, out);
    if (kind_ == Dither::Ordered2 || kind_ == Dither::Ordered3 || kind_ == Dither::Ordered4) {
        for (std::size_t c = 0; c < count; ++c) out[c] = with_pattern(x, y, levels[c], *curves[c]);
        return;
    }
    if (kind_ == Dither::Carry) {
        for (std::size_t c = 0; c < count; ++c)
            out[c] = with_error(levels[c] + next_pixel_[c], *curves[c], next_pixel_[c]);
        return;
    }
    std::array<float, kMostChannels> errors{};
    for (std::size_t c = 0; c < count; ++c)
        out[c] = with_error(levels[c] + carried(this_row_, x, static_cast<int>(c)), *curves[c], errors[c]);
    // POV-Ray goes on to the next row only here, when the first pixel has had its error from the row before: what is
    // carried to column 0 comes a row late.
    if (x == 0) {
        std::swap(this_row_, next_row_);
        std::fill(next_row_.begin(), next_row_.end(), 0.0f);
    }
    for (std::size_t c = 0; c < count; ++c) spread(x, static_cast<int>(c), errors[c]);
}

}  // namespace image
