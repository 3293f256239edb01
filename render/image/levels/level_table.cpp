#include "render/image/levels/level_table.h"

#include "render/image/levels/quantise.h"

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
        levels_[i] = static_cast<std::uint8_t>(level);
    }
}

}  // namespace image
