#pragma once

#include "numbers/lane_equal.h"
#include "render/texture/map_points.h"

namespace texture {

/// The bits of the first `count` points, 1 to 64.
inline std::uint64_t first_bits(std::size_t count)
{
    return count < kMostPoints ? (std::uint64_t{1} << count) - 1 : ~std::uint64_t{0};
}

/// Calls f(entry, which), in order, for each entry of a map, counted from its first, that some of the first `count`
/// blends look at (1 to 64 of them); bit i of `which` is set if blend i does.
template <class F>
inline void each_entry(const BlendPoints& blends, std::uint32_t entries, std::size_t count, F&& f)
{
    const std::uint64_t all = first_bits(count);
    std::uint64_t lower = 0, upper = 0;  // whose entries have been found
    for (std::uint32_t entry = 0; entry < entries && (lower & upper) != all; ++entry) {
        const std::uint64_t low = all & numbers::lanes::equal(blends.lower, entry),
                            high = all & numbers::lanes::equal(blends.upper, entry);
        lower |= low;
        upper |= high;
        if ((low | high) != 0) f(entry, low | high);
    }
}

}  // namespace texture
