#pragma once

#include "numbers/functions/tables.h"

/// Inverse trigonometric functions: the tangent minus the nearest of k / 64 is that of a small angle, by one division.
namespace numbers {

inline constexpr double kMostQuickSize = 0x1p400, kLeastQuickSize = 0x1p-400;  // no product is too great or too small
inline constexpr double kLeastTangent = 0x1p-27;                               // below, it is its own angle

/// The angle from the axis x to (x, y), both not negative; from -x if `left`.
template <class V, class Truth>
inline V angle_of(const Pair<V>& y, const Pair<V>& x, const Truth& left)
{
    constexpr double kRound = 6755399441055744.0;
    using W = decltype(words_of(x.high));
    const auto steep = x.high < y.high;
    const Pair<V> a{choose(steep, y.high, x.high), choose(steep, y.low, x.low)};
    const Pair<V> b{choose(steep, x.high, y.high), choose(steep, x.low, y.low)};

    const V shifted = b.high / a.high * V(kAngleSteps) + V(kRound);
    const V c = (shifted - V(kRound)) * V(1.0 / kAngleSteps);
    const W row = words_of(shifted) & W(std::uint64_t{127});
    // (b - c a) / (a + c b), where c has 7 bits
    const V a_top = top(a.high), b_top = top(b.high);
    const Pair<V> n0 = exact_sum(b.high, V(0.0) - c * a_top), n1 = exact_sum(n0.high, V(0.0) - c * (a.high - a_top));
    const Pair<V> n = ordered_sum(n1.high, (n1.low + n0.low) + (b.low - c * a.low));
    const Pair<V> d0 = ordered_sum(a.high, c * b_top);
    const Pair<V> d = ordered_sum(d0.high, d0.low + c * (b.high - b_top) + (a.low + c * b.low));
    const Pair<V> t = n / d;

    constexpr std::array<double, 4> kSeries = {-1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9};
    const V q = t.high * t.high, small = t.low + t.high * q * lanes::polynomial(kSeries, q);
    // 0, a right angle or a straight one, plus or minus that of the table and the small one
    const V zero(0.0), one(1.0), sign = choose(lanes::differ(steep, left), V(-1.0), one);
    const V turns = choose(steep, one, choose(left, V(2.0), zero));
    const Pair<V> base = ordered_sum(turns * V(kHalfPi.high), sign * column<0>(kAngles, row));
    const Pair<V> sum = ordered_sum(base.high, sign * t.high);
    return sum.high + ((sum.low + base.low) + (turns * V(kHalfPi.low) + sign * (column<1>(kAngles, row) + small)));
}

template <class V>
inline Pair<V> plain(const V& v)
{
    return {v, V(0.0)};
}
/// The cosine of the angle whose sine is x, and the other way round.
template <class V>
inline Pair<V> other_side(const V& x)
{
    const Pair<V> p = exact_product(x, x), s = ordered_sum(V(1.0), V(0.0) - p.high);
    return root_of(ordered_sum(s.high, s.low - p.low));
}

template <class V>
inline auto in_quick_range(const V& v)
{
    return (V(kLeastQuickSize) < v) & (v < V(kMostQuickSize));
}
template <class V>
inline V quick_atan(const V& x)
{
    const V a = size_of(x);
    return choose(a < V(kLeastTangent), x, signed_as(angle_of(plain(a), plain(V(1.0)), a < V(0.0)), x));
}
template <class V>
inline V quick_atan2(const V& y, const V& x)
{
    return signed_as(angle_of(plain(size_of(y)), plain(size_of(x)), x < V(0.0)), y);
}
template <class V>
inline V quick_asin(const V& x)
{
    const V a = size_of(x);
    return choose(a < V(kLeastTangent), x, signed_as(angle_of(plain(a), other_side(a), a < V(0.0)), x));
}
template <class V>
inline V quick_acos(const V& x)
{
    return angle_of(other_side(x), plain(size_of(x)), x < V(0.0));
}
template <class V>
inline V quick_hypot(const V& x, const V& y)
{
    const Pair<V> s = exact_product(x, x) + exact_product(y, y), r = root_of(s);
    return r.high + r.low;
}

}  // namespace numbers
