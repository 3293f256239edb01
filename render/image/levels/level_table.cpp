#include "render/image/levels/level_table.h"

#include "render/image/levels/quantise.h"

#include <algorithm>
#include <limits>

namespace image {
namespace {

float float_of(std::uint32_t bits) { return std::bit_cast<float>(bits); }

}  // namespace

LevelTable::LevelTable(const Transcoder& curve, int bits)
{
    constexpr std::uint32_t kInfinite = std::bit_cast<std::uint32_t>(std::numeric_limits<float>::infinity());
    const auto level_of = [&](std::uint32_t x) { return std::uint32_t{quantised(curve.to_file(float_of(x)), bits)}; };
    begins_.fill(std::numeric_limits<float>::quiet_NaN());
    const std::uint32_t most = (1u << bits) - 1;
    std::uint32_t below = 0;
    for (std::uint32_t level = 1; level <= most; ++level) {
        // The level begins near where its lower end is decoded to; steps that grow from there enclose it.
        const float guess = curve.to_working((static_cast<float>(level) - 0.5f) / static_cast<float>(most));
        std::uint32_t at = guess > 0.0f ? std::bit_cast<std::uint32_t>(guess) : 0;
        if (at < below || at > kInfinite) at = below;
        std::uint32_t low = at, high = at, step = 1;
        while (low > below && level_of(low) >= level) low = low - below > step ? low - step : below, step *= 2;
        for (step = 1; level_of(high) < level; step *= 2) high = kInfinite - high > step ? high + step : kInfinite;
        while (high - low > 1) {
            const std::uint32_t middle = low + (high - low) / 2;
            (level_of(middle) >= level ? high : low) = middle;
        }
        begins_[level - 1] = float_of(high);
        below = low;
    }
    std::size_t level = 0;
    for (std::uint32_t i = 0; i < levels_.size(); ++i) {
        while (float_of((kFirst + i) << kShift) >= begins_[level]) ++level;
        levels_[i] = i == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(level);
        steps_by_one_ = steps_by_one_ && (i == 0 || level - levels_[i - 1] <= 1);
    }
    steps_by_one_ = steps_by_one_ && most - level <= 1;
}

void LevelTable::round(const float* pixels, std::size_t count, std::uint16_t* out) const
{
    constexpr std::size_t kAtOnce = 64;  // pixels: their places are worked out in registers
    std::array<std::uint32_t, 4 * kAtOnce> places;
    for (std::size_t first = 0; first < count; first += kAtOnce) {
        const std::size_t numbers = 4 * std::min(kAtOnce, count - first);
        for (std::size_t i = 0; i < numbers; ++i) places[i] = place_of(pixels[i]);
        for (std::size_t i = 0; i < numbers; i += 4, out += 3)
            for (std::size_t c = i; c < i + 3; ++c)
                out[c - i] = static_cast<std::uint16_t>(level(pixels[c], places[c]));
        pixels += numbers;
    }
}

}  // namespace image
