#pragma once

#include "render/texture/points/points.h"

#include "numbers/functions/lane_functions.h"
#include "render/texture/points/angle.h"

#include <cstddef>

namespace texture {

/// Points that go through the vector unit together.
using numbers::lanes::Double;
inline constexpr std::size_t kLanes = static_cast<std::size_t>(numbers::lanes::kDoubles);

/// Of each.
inline Double series_cycle(const Double& v)
{
    const Double size = xsimd::abs(v),
                 s = turn_sine(size - xsimd::floor(size), [](const auto&where, const Double&a, const Double&b) {
                     return xsimd::select(where, a, b);
                 });
    return xsimd::select(v >= Double(0.0), s, -s);
}

inline Double cycle(const Double& v)
{
    const Double size = xsimd::abs(v), s = numbers::sin(Double(kTau) * (size - xsimd::floor(size)));
    return xsimd::select(v >= Double(0.0), s, -s);
}

/// The numbers of points i, i + 1, ...
inline Double get(const Values& v, std::size_t i) { return Double::load_aligned(v.data() + i); }

}  // namespace texture
