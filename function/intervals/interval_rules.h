#pragma once

#include "function/intervals/interval.h"
#include "function/machine.h"

/// What one interval and eight of them share.
namespace function {

inline constexpr double kMostRounds = 100'000;  // of a sum or prod; the value of a longer one is not bounded

/// Whether branch k of `count` of a select() can be taken when its condition is c.
inline bool branch_possible(const Interval& c, std::size_t count, std::size_t k)
{
    if (k == 0) return c.low < 0.0;
    if (count == 2) return c.high >= 0.0;
    return k == 1 ? c.contains(0.0) : c.high > 0.0;
}

/// The ranges of the coordinates of transformed points. I is Interval or Ends.
template <class I>
inline void moved_ranges(const csg::Transform& by, const I* a, I* out)
{
    for (int row = 0; row < 3; ++row)
        out[row] = a[0] * by.linear[0][row] + a[1] * by.linear[1][row] + a[2] * by.linear[2][row] + by.offset[row];
}

/// The range of internal(n) where its arguments lie in a[0], a[1], ...
Interval internal_interval(std::uint32_t n, const Interval* a);
/// The ranges of what a function asks of its surroundings (a transformation, pattern, pigment or spline): five
/// components to `out`.
void outer_interval(const SceneReference& what, const Interval* a, Interval* out);

}  // namespace function
