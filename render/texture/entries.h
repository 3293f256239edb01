#pragma once

#include "render/texture/evaluate.h"

#include <algorithm>
#include <array>

namespace texture {

/// Calls f(entry, which), in order, for each entry of a map that some of the first `count` blends look at (1 to 64 of
/// them); bit i of `which` is set if blends[i] does.
template <class Blends, class F>
inline void each_entry(const Blends& blends, std::size_t count, F&& f)
{
    constexpr std::uint32_t kAtOnce = 64;  // maps have up to 256, of which a tile's points look at a few
    std::uint32_t first = blends[0].lower, last = blends[0].upper;
    for (std::size_t i = 1; i < count; ++i) {
        first = std::min(first, blends[i].lower);
        last = std::max(last, blends[i].upper);
    }
    for (std::uint32_t base = first; base <= last; base += kAtOnce) {
        std::array<std::uint64_t, kAtOnce> which{};
        for (std::size_t i = 0; i < count; ++i)
            for (const std::uint32_t entry : {blends[i].lower, blends[i].upper})
                if (entry - base < kAtOnce) which[entry - base] |= std::uint64_t{1} << i;
        for (std::uint32_t k = 0; k < kAtOnce; ++k)
            if (which[k] != 0) f(base + k, which[k]);
    }
}

}  // namespace texture
