#pragma once

#include "numbers/lanes.h"
#include "numbers/safeguarded_newton.h"

#include <type_traits>

namespace numbers::lanes {

/// A function and its derivative at a place, a lane each.
struct ValuesAndSlopes {
    Double value, slope;
};

/// safeguarded_newton(), each lane within its own bracket: what one alone comes to, to the last bit.
template <bool halving>
struct NewtonOf {
    Double lo, hi, t;
    Double::batch_bool_type negative_at_lo;
    Double before = Double(0.0);  ///< of halving ones the last step's length: hi - lo at first

    /// One step of the lanes asked for, from `here` at t; those that end with it are taken out. The last is one no
    /// longer than `close`.
    void step(const ValuesAndSlopes& here, const Double& close, std::uint32_t& asked)
    {
        const Double zero(0.0);
        auto hit = here.value == zero;
        const auto below = here.value < zero;
        const auto low = (below & negative_at_lo) | ((!below) & (!negative_at_lo));
        lo = xsimd::select(low, t, lo);
        hi = xsimd::select(low, hi, t);
        const Double to = t - here.value / here.slope;
        if constexpr (halving) hit = hit | (to == t);
        auto inside = (to > lo) & (to < hi);
        if constexpr (halving) inside = inside & !(xsimd::abs(to - t) > Double(0.5) * before);
        const Double next = xsimd::select(inside, to, Double(0.5) * (lo + hi)), way = xsimd::abs(next - t);
        const auto ends = (way <= close) | (next == lo) | (next == hi);
        if constexpr (halving) before = way;
        t = xsimd::select(lanes_of(asked & ~mask(hit)), next, t);
        asked &= ~mask(hit | ends);
    }
};

using Newton = NewtonOf<false>;

template <class T>
using Sloped = std::conditional_t<std::is_same_v<T, double>, ValueAndSlope, ValuesAndSlopes>;

/// safeguarded_newton() of one number, or of the lanes asked for.
template <class At>
inline double change_of_sign(const At& at, double lo, double hi, bool negative_at_lo, double t, StepEnd end, int most,
                             std::uint32_t)
{
    return safeguarded_newton(at, lo, hi, negative_at_lo, t, end, most);
}
template <class At>
inline Double change_of_sign(const At& at, const Double& lo, const Double& hi,
                             const Double::batch_bool_type& negative_at_lo, const Double& t, StepEnd end, int most,
                             std::uint32_t asked)
{
    Newton newton{lo, hi, t, negative_at_lo};
    for (int i = 0; i < most && asked != 0; ++i) {
        Double close(end.absolute);
        if (end.relative != 0.0) close += Double(end.relative) * xsimd::abs(newton.t);
        newton.step(at(newton.t), close, asked);
    }
    return newton.t;
}

}  // namespace numbers::lanes
