#pragma once

#include "numbers/lanes.h"
#include "csg/base/types.h"

#include <algorithm>
#include <array>

/// The smallest numbers of some, lane by lane.
namespace texture {

/// The `Count` (1 to 3) smallest numbers that each lane took, ascending; what is no number counts for nothing.
template <int Count>
struct NearestLanes {
    using Double = numbers::lanes::Double;
    Double first = Double(numbers::kInfinity), second = first, third = first;

    void take(const Double& d)
    {
        // The second operand is the result where the first is no number.
        const Double behind_first = xsimd::max(d, first);
        if constexpr (Count > 2) third = xsimd::min(xsimd::max(behind_first, second), third);
        if constexpr (Count > 1) second = xsimd::min(behind_first, second);
        first = xsimd::min(d, first);
    }
    const Double& last() const { return Count > 2 ? third : Count > 1 ? second : first; }

    /// The smallest of all lanes; only `Count` of them count.
    std::array<double, 3> merged() const
    {
        std::array<double, 3> best{numbers::kInfinity, numbers::kInfinity, numbers::kInfinity};
        const auto merge = [&best](const Double& of) {
            alignas(64) std::array<double, numbers::lanes::kDoubles> lanes;
            of.store_aligned(lanes.data());
            for (const double d : lanes) {
                const double behind_first = std::max(d, best[0]);
                if (Count > 2) best[2] = std::min(std::max(behind_first, best[1]), best[2]);
                if (Count > 1) best[1] = std::min(behind_first, best[1]);
                best[0] = std::min(d, best[0]);
            }
        };
        merge(first);
        if constexpr (Count > 1) merge(second);
        if constexpr (Count > 2) merge(third);
        return best;
    }
};

}  // namespace texture
