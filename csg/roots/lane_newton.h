#pragma once

#include "csg/base/lanes.h"

/// Compiled once per instruction set.
namespace csg::lanes {

/// A function and its derivative at a place, a lane each.
struct ValuesAndSlopes {
    Double value, slope;
};

/// safeguarded_newton(), each lane within its own bracket: what one alone comes to, to the last bit.
struct Newton {
    Double lo, hi, t;
    Double::batch_bool_type negative_at_lo;

    /// One step of the lanes asked for, from `here` at t; those that end with it are taken out. The last is one no
    /// longer than `close`.
    void step(const ValuesAndSlopes& here, double close, std::uint32_t& asked)
    {
        const Double zero(0.0);
        const auto hit = here.value == zero, below = here.value < zero;
        const auto low = (below & negative_at_lo) | ((!below) & (!negative_at_lo));
        lo = xsimd::select(low, t, lo);
        hi = xsimd::select(low, hi, t);
        const Double to = t - here.value / here.slope;
        const Double next = xsimd::select((to > lo) & (to < hi), to, Double(0.5) * (lo + hi));
        const auto ends = (xsimd::abs(next - t) <= Double(close)) | (next == lo) | (next == hi);
        t = xsimd::select(lanes_of(asked & ~mask(hit)), next, t);
        asked &= ~mask(hit | ends);
    }
};

}  // namespace csg::lanes
