#pragma once

#include "render/image/levels/transfer_curve.h"

#include <array>
#include <bit>
#include <cstdint>

namespace image {

/// quantised(curve.to_file(x), bits) without a power for each sample: where each level begins is looked for once.
class LevelTable {
public:
    static constexpr int kMostBits = 8;

    /// bits <= kMostBits
    LevelTable(const Transcoder& curve, int bits);

    std::uint16_t operator()(float x) const { return static_cast<std::uint16_t>(level(x, place_of(x))); }

    /// Of the colours of `count` pixels, four numbers each, three levels each.
    void round(const float* pixels, std::size_t count, std::uint16_t* out) const;

private:
    /// Floats between 2^-24 and 1 in groups of one exponent and 7 bits of the mantissa; level 1 of a gamma of 2.2
    /// begins at 2^-20. The first group begins at 0, the last one ends nowhere.
    static constexpr int kShift = 16;
    static constexpr float kLow = 0x1p-24f;
    static constexpr std::uint32_t kFirst = std::bit_cast<std::uint32_t>(kLow) >> kShift,
                                   kEnd = (std::bit_cast<std::uint32_t>(1.0f) >> kShift) + 1;

    static std::uint32_t place_of(float x)
    {
        const float above = x > kLow ? x : kLow, within = above < 1.0f ? above : 1.0f;  // NaN and all below 0: kLow
        return (std::bit_cast<std::uint32_t>(within) >> kShift) - kFirst;
    }
    std::size_t level(float x, std::uint32_t place) const
    {
        std::size_t level = levels_[place];
        level += x >= begins_[level] ? 1 : 0;  // most groups begin one level at most: no branch to guess
        while (!steps_by_one_ && x >= begins_[level]) ++level;
        return level;
    }

    std::array<float, (1u << kMostBits) + 1> begins_;  ///< the least x of level i + 1; NaN behind the last
    std::array<std::uint8_t, kEnd - kFirst> levels_;   ///< of a group's first float
    bool steps_by_one_ = true;                         ///< no group begins two levels
};

}  // namespace image
