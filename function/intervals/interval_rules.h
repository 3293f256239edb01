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

/// The range of internal(n) where its arguments lie in a[0], a[1], ...
Interval internal_interval(std::uint32_t n, const Interval* a);
/// The ranges of what a function asks of its surroundings (a transformation, pattern, pigment or spline): five
/// components to `out`.
void outer_interval(const SceneReference& what, const Interval* a, Interval* out);

}  // namespace function
