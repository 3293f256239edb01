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

    std::uint16_t operator()(float x) const
    {
        if (!(x > 0.0f)) return 0;  // NaN too
        const std::uint32_t place = std::bit_cast<std::uint32_t>(x) >> kShift;
        std::size_t level = place <= kFirst ? 0 : levels_[place < kEnd ? place - kFirst : kEnd - 1 - kFirst];
        level += x >= begins_[level] ? 1 : 0;  // most groups begin one level at most: no branch to guess
        while (x >= begins_[level]) ++level;
        return static_cast<std::uint16_t>(level);
    }

private:
    /// Floats between 2^-24 and 1 in groups of one exponent and 7 bits of the mantissa; level 1 of a gamma of 2.2
    /// begins at 2^-20.
    static constexpr int kShift = 16;
    static constexpr std::uint32_t kFirst = std::bit_cast<std::uint32_t>(0x1p-24f) >> kShift,
                                   kEnd = (std::bit_cast<std::uint32_t>(1.0f) >> kShift) + 1;

    std::array<float, (1u << kMostBits) + 1> begins_;  ///< the least x of level i + 1; NaN behind the last
    std::array<std::uint8_t, kEnd - kFirst> levels_;   ///< of a group's first float
};

}  // namespace image
