#include "render/image/levels/blue_noise.h"
#include "render/image/levels/dither.h"
#include "render/image/levels/quantise.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

/// Dithering as POV-Ray 3.8 does it: by shares of light, whatever the file's transfer curve (spec 7, 3.3).
namespace image {
namespace {

/// Places of the pattern in the order in which they light up, from 0.
constexpr int kBayer2[2][2] = {{0, 2}, {3, 1}};
constexpr int kBayer3[3][3] = {{0, 3, 6}, {7, 1, 4}, {5, 8, 2}};
constexpr int kBayer4[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};

template <int N>
float place_in(const int (&pattern)[N][N], int x, int y)
{
    return (static_cast<float>(pattern[y % N][x % N]) + 0.5f) / static_cast<float>(N * N);
}

/// Of a pixel in the pattern, in (0, 1).
float place_of(Dither kind, int x, int y, std::size_t channel)
{
    switch (kind) {
    case Dither::Bayer2: return place_in(kBayer2, x, y);
    case Dither::Bayer3: return place_in(kBayer3, x, y);
    case Dither::Bayer4: return place_in(kBayer4, x, y);
    default: break;
    }
    const float place = blue_noise(x, y);
    return kind == Dither::BlueNoiseExchanged && channel % 2 == 0 ? 1.0f - place : place;
}

/// What a neighbour gets of an error.
struct Share {
    int x, y;
    float part;
};

/// As the methods were published: Sierra 1989/1990, Atkinson (HyperScan, 1987), Burkes 1988, Jarvis, Judice and Ninke
/// 1976, Stucki 1981, Floyd and Steinberg 1976.
std::span<const Share> shares_of(Dither kind)
{
    static constexpr Share kSierraLite[] = {{1, 0, 2 / 4.f}, {-1, 1, 1 / 4.f}, {0, 1, 1 / 4.f}};
    static constexpr Share kFloydSteinberg[] = {
        {1, 0, 7 / 16.f}, {-1, 1, 3 / 16.f}, {0, 1, 5 / 16.f}, {1, 1, 1 / 16.f}};
    static constexpr Share kAtkinson[] = {{1, 0, 1 / 8.f}, {2, 0, 1 / 8.f}, {-1, 1, 1 / 8.f},
                                          {0, 1, 1 / 8.f}, {1, 1, 1 / 8.f}, {0, 2, 1 / 8.f}};
    static constexpr Share kBurkes[] = {{1, 0, 8 / 32.f}, {2, 0, 4 / 32.f}, {-2, 1, 2 / 32.f}, {-1, 1, 4 / 32.f},
                                        {0, 1, 8 / 32.f}, {1, 1, 4 / 32.f}, {2, 1, 2 / 32.f}};
    static constexpr Share kJarvis[] = {{1, 0, 7 / 48.f},  {2, 0, 5 / 48.f}, {-2, 1, 3 / 48.f}, {-1, 1, 5 / 48.f},
                                        {0, 1, 7 / 48.f},  {1, 1, 5 / 48.f}, {2, 1, 3 / 48.f},  {-2, 2, 1 / 48.f},
                                        {-1, 2, 3 / 48.f}, {0, 2, 5 / 48.f}, {1, 2, 3 / 48.f},  {2, 2, 1 / 48.f}};
    static constexpr Share kSierra2[] = {{1, 0, 4 / 16.f}, {2, 0, 3 / 16.f}, {-2, 1, 1 / 16.f}, {-1, 1, 2 / 16.f},
                                         {0, 1, 3 / 16.f}, {1, 1, 2 / 16.f}, {2, 1, 1 / 16.f}};
    static constexpr Share kSierra3[] = {{1, 0, 5 / 32.f}, {2, 0, 3 / 32.f}, {-2, 1, 2 / 32.f}, {-1, 1, 4 / 32.f},
                                         {0, 1, 5 / 32.f}, {1, 1, 4 / 32.f}, {2, 1, 2 / 32.f},  {-1, 2, 2 / 32.f},
                                         {0, 2, 3 / 32.f}, {1, 2, 2 / 32.f}};
    static constexpr Share kStucki[] = {{1, 0, 8 / 42.f},  {2, 0, 4 / 42.f}, {-2, 1, 2 / 42.f}, {-1, 1, 4 / 42.f},
                                        {0, 1, 8 / 42.f},  {1, 1, 4 / 42.f}, {2, 1, 2 / 42.f},  {-2, 2, 1 / 42.f},
                                        {-1, 2, 2 / 42.f}, {0, 2, 4 / 42.f}, {1, 2, 2 / 42.f},  {2, 2, 1 / 42.f}};
    switch (kind) {
    case Dither::SierraLite: return kSierraLite;
    case Dither::FloydSteinbergLight: return kFloydSteinberg;
    case Dither::Atkinson: return kAtkinson;
    case Dither::Burkes: return kBurkes;
    case Dither::JarvisJudiceNinke: return kJarvis;
    case Dither::SierraTwoRows: return kSierra2;
    case Dither::SierraThreeRows: return kSierra3;
    default: return kStucki;
    }
}

/// The two levels about a sample: the lower one, and what they stand for in working space.
struct Between {
    std::uint16_t low;
    float lower, upper;
};
Between levels_about(float level, const Transcoder& curve, int bits)
{
    const int most = (1 << bits) - 1;
    const float scaled = std::clamp(curve.to_file(level), 0.0f, 1.0f) * static_cast<float>(most);
    const int low = std::min(static_cast<int>(scaled), most - 1);
    const auto light = [&](int of) { return curve.to_working(static_cast<float>(of) / static_cast<float>(most)); };
    return {static_cast<std::uint16_t>(low), light(low), light(low + 1)};
}

}  // namespace

void Ditherer::round_by_light(int x, int y, const float* levels, const Transcoder* const* curves, std::uint16_t* out)
{
    const auto count = static_cast<std::size_t>(channels_);
    const auto level_above = [](const Between& b, bool above) {
        return static_cast<std::uint16_t>(b.low + (above ? 1 : 0));
    };
    if (kind_ <= Dither::BlueNoiseExchanged) {
        for (std::size_t c = 0; c < count; ++c) {
            const Between b = levels_about(levels[c], *curves[c], bits_);
            const float share = (std::clamp(levels[c], 0.0f, 1.0f) - b.lower) / (b.upper - b.lower);
            const float place = place_of(kind_, x, y, c);
            // POV-Ray turns the pattern over where levels are light itself.
            out[c] = level_above(b, curves[c]->keeps() ? share + place >= 1.0f : share > place);
        }
        return;
    }
    for (; row_ < y; ++row_) {
        std::swap(this_row_, next_row_);
        std::swap(next_row_, third_row_);
        std::fill(third_row_.begin(), third_row_.end(), 0.0f);
    }
    row_ = y;
    const std::array<std::vector<float>*, 3> rows = {&this_row_, &next_row_, &third_row_};
    for (std::size_t c = 0; c < count; ++c) {
        const auto channel = static_cast<int>(c);
        const float wanted = levels[c] + carried(this_row_, x, channel);
        const Between b = levels_about(wanted, *curves[c], bits_);
        const float light = std::clamp(wanted, 0.0f, 1.0f);
        const bool above = light - b.lower >= b.upper - light;
        out[c] = level_above(b, above);
        const float error = wanted - (above ? b.upper : b.lower);
        for (const Share& share : shares_of(kind_))
            if (x + share.x >= 0 && x + share.x < width_)
                carried(*rows[static_cast<std::size_t>(share.y)], x + share.x, channel) += error * share.part;
    }
}

}  // namespace image
