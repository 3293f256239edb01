#pragma once

#include <array>

/// A polynomial of x, y and z along a ray, unrolled for a degree that the compiler knows: a quartic in 40 ns instead of
/// 170.
namespace csg::detail {

/// Of t, lowest power first. V: of one ray, or of a ray a lane.
template <int degree, class V>
using Powers = std::array<V, degree + 1>;

/// p times (o + d t).
template <int degree, class V>
[[gnu::always_inline]] inline Powers<degree + 1, V> times(const Powers<degree, V>& p, const V& o, const V& d)
{
    Powers<degree + 1, V> out;
    out[0] = p[0] * o;
    for (std::size_t i = 1; i <= degree; ++i) out[i] = p[i] * o + p[i - 1] * d;
    out[degree + 1] = p[degree] * d;
    return out;
}

/// o + d t in each of the three coordinates.
template <class V>
struct Course {
    V o[3], d[3];
};

/// Horner's scheme in x, whose coefficients are polynomials of y and z, and so on: each takes its coefficients in
/// POV-Ray's order, the highest power first, from `next`. Powers of coordinate `axis` from `lowest` to `degree`, over
/// that to the lowest.
template <int axis, int degree, int lowest = 0, class V>
[[gnu::always_inline]] inline auto along(const double*& next, const Course<V>& c)
{
    if constexpr (axis == 3) {
        return Powers<0, V>{V(*next++)};
    } else if constexpr (lowest == degree) {
        return along<axis + 1, 0>(next, c);
    } else {
        auto out = times<degree - lowest - 1, V>(along<axis, degree, lowest + 1>(next, c), c.o[axis], c.d[axis]);
        const auto plus = along<axis + 1, degree - lowest>(next, c);
        for (std::size_t i = 0; i < plus.size(); ++i) out[i] += plus[i];
        return out;
    }
}

}  // namespace csg::detail
