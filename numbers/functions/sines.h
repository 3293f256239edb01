#pragma once

#include "numbers/functions/tables.h"

/// Sine, cosine and tangent: the angle minus the nearest multiple of pi / 64 is small, and sine and cosine of that
/// multiple stand in a table.
namespace numbers {

/// An angle reduced to step * (pi / 64) + rest, |rest| <= pi / 128; step counts modulo 128.
template <class V, class W = decltype(words_of(std::declval<V>()))>
struct Turned {
    W step;
    Pair<V> rest;
};

inline constexpr double kMostQuickAngle = 0x1p15;  // up to it, step times the first three parts of pi / 64 is exact
inline constexpr double kLeastAngle = 0x1p-27;     // below it, an angle is its own sine and tangent

template <class V>
inline Turned<V> turned(const V& x)
{
    constexpr double kSteps = 0x1.45f306dc9c883p+4,  // 64 / pi
        kRound = 6755399441055744.0;                 // 1.5 2^52: what is added to it loses its fraction
    constexpr double kPart[] = {0x1.921fb544p-5, 0x1.0b4611a6p-39, 0x1.3198a2ep-74, 0x1.b839a252049c1p-109};
    const V shifted = x * V(kSteps) + V(kRound), k = shifted - V(kRound);
    const Pair<V> near = exact_sum(x - k * V(kPart[0]), k * V(-kPart[1]));
    const Pair<V> nearer = exact_sum(near.high, k * V(-kPart[2]));
    return {words_of(shifted), {nearer.high, (nearer.low + near.low) - k * V(kPart[3])}};
}

/// The sine, as a sum of which the second part is below 2^-10 of the first.
template <class V, class W>
inline Pair<V> sine_of(const Turned<V, W>& of)
{
    const W row = of.step & W(std::uint64_t{2 * kSineSteps - 1});
    const V s = column<0>(kSines, row), s_low = column<1>(kSines, row), c_top = column<2>(kSines, row),
            c_rest = column<3>(kSines, row);
    const V r = of.rest.high, r_top = top(r), r_rest = (r - r_top) + of.rest.low, q = r * r;
    const V sine = r * q * (V(-1.0 / 6) + q * (V(1.0 / 120) - q * V(1.0 / 5040)));                          // minus r
    const V cosine = q * ((V(-1.0 / 2) + q * V(1.0 / 24)) + q * q * (V(-1.0 / 720) + q * V(1.0 / 40320)));  // minus 1
    const Pair<V> sum = ordered_sum(s, c_top * r_top);
    return {sum.high, sum.low + ((s_low + c_top * r_rest) + (c_rest * r + ((c_top + c_rest) * sine + s * cosine)))};
}
template <class V, class W>
inline Pair<V> cosine_of(const Turned<V, W>& of)
{
    return sine_of(Turned<V, W>{of.step + W(std::uint64_t{kSineSteps / 2}), of.rest});
}

template <class V>
inline V quick_sine(const V& x, const Turned<V>& of)
{
    const Pair<V> s = sine_of(of);
    return choose(size_of(x) < V(kLeastAngle), x, s.high + s.low);
}
template <class V>
inline V quick_cosine(const Turned<V>& of)
{
    const Pair<V> c = cosine_of(of);
    return c.high + c.low;
}
template <class V>
inline V quick_tangent(const V& x, const Turned<V>& of)
{
    const Pair<V> s = sine_of(of), c = cosine_of(of);
    const Pair<V> q = ordered_sum(s.high, s.low) / ordered_sum(c.high, c.low);
    return choose(size_of(x) < V(kLeastAngle), x, q.high);
}

}  // namespace numbers
