#pragma once

#include "numbers/functions/exponentials.h"

/// Logarithms, powers and inverse hyperbolic functions: a mantissa times its about 1 / m of a table is 1 + r, exactly.
namespace numbers {

/// Positive, normal, finite.
template <class V>
inline auto is_plain(const V& x)
{
    return (V(0x1p-1022) <= x) & (x <= V(0x1.fffffffffffffp1023));
}

/// ln x = first + r - r^2 / 2 + ... + rest, of plain x. Where `first` is not 0, it is more than r.
template <class V>
struct LogarithmParts {
    V first, r, r_rest, rest;
};
template <class V>
inline LogarithmParts<V> logarithm_parts(const V& x)
{
    constexpr double kLn2First = 0x1.62e42fefa38p-1, kLn2Rest = 0x1.ef35793c7673p-45;  // whole 2^-42
    using W = decltype(words_of(x));
    const W from = words_of(x) + W((std::uint64_t{1023} << 52) - kLeastMantissa), steps = from >> 52;
    const W row = (from >> kMantissaBits) & W(std::uint64_t{127});
    const V k = number_of(steps | W(std::uint64_t{0x433} << 52)) - V(4503599627370496.0 + 1023.0);  // 2^52: as a number
    const V m = number_of(words_of(x) - ((steps - W(std::uint64_t{1023})) << 52));
    const V inverse = column<0>(kLogarithms, row), m_top = number_of(words_of(m) & W(~std::uint64_t{0x1fffff}));
    // 32 bits of the mantissa and 12 of the inverse: exact
    const V high = m_top * inverse - V(1.0), low = (m - m_top) * inverse, r = high + low;
    return {k * V(kLn2First) + column<1>(kLogarithms, row), r, low - (r - high),
            k * V(kLn2Rest) + column<2>(kLogarithms, row)};
}

template <class V>
inline V quick_logarithm(const V& x)
{
    constexpr std::array<double, 8> kSeries = {-1.0 / 2, 1.0 / 3, -1.0 / 4, 1.0 / 5,
                                               -1.0 / 6, 1.0 / 7, -1.0 / 8, 1.0 / 9};
    const LogarithmParts<V> of = logarithm_parts(x);
    const Pair<V> sum = ordered_sum(of.first, of.r);
    return sum.high + ((sum.low + (of.rest + of.r_rest)) + of.r * of.r * lanes::polynomial(kSeries, of.r));
}

/// ln x + more, to 2^-68 of it, for plain x; `more` is small beside ln x, or x is 1.
template <class V>
inline Pair<V> logarithm_of(const V& x, const V& more)
{
    constexpr std::array<double, 8> kSeries = {1.0 / 3, -1.0 / 4, 1.0 / 5, -1.0 / 6,
                                               1.0 / 7, -1.0 / 8, 1.0 / 9, -1.0 / 10};
    const LogarithmParts<V> of = logarithm_parts(x);
    const V r = of.r, r_top = top(r), half = V(0.5) * r_top * r_top, half_rest = V(0.5) * (r - r_top) * (r + r_top);
    const Pair<V> a = ordered_sum(of.first, r), b = ordered_sum(a.high, V(0.0) - half);
    const V curved = r * r * r * lanes::polynomial(kSeries, r) - half_rest;
    return ordered_sum(b.high, ((a.low + b.low) + (of.rest + more)) + ((of.r_rest - of.r_rest * r) + curved));
}
template <class V>
inline V quick_logarithm(const V& x, const Pair<double>& scale)
{
    return (logarithm_of(x, V(0.0)) * Pair<V>{V(scale.high), V(scale.low)}).high;
}
inline constexpr Pair<double> kPerLn10{0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};
inline constexpr Pair<double> kPerLn2{0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56};

/// y ln x, where low is below 2^-24 of high.
template <class V>
inline Pair<V> exponent_of(const Pair<V>& logarithm, const V& y)
{
    const V l = top(logarithm.high), l_rest = (logarithm.high - l) + logarithm.low, y_top = top(y);
    return {y_top * l, (y - y_top) * l + y * l_rest};
}

/// The logarithm of a pair.
template <class V>
inline V logarithm_of(const Pair<V>& x)
{
    return logarithm_of(x.high, x.low / x.high).high;
}
inline constexpr double kMostSquared = 0x1p480, kLeastCurved = 0x1p-28;  // below, the functions are their argument

template <class V>
inline V quick_asinh(const V& x)
{
    const V a = size_of(x);
    const Pair<V> one{V(1.0), V(0.0)}, size{a, V(0.0)}, s = exact_product(a, a);
    return choose(a < V(kLeastCurved), x, signed_as(logarithm_of(size + root_of(one + s)), x));
}
template <class V>
inline V quick_acosh(const V& x)
{
    const Pair<V> minus_one{V(-1.0), V(0.0)}, size{x, V(0.0)}, s = exact_product(x, x);
    return logarithm_of(size + root_of(s + minus_one));
}
template <class V>
inline V quick_atanh(const V& x)
{
    const V a = size_of(x);
    const Pair<V> q = ordered_sum(V(1.0), a) / ordered_sum(V(1.0), V(0.0) - a);
    return choose(a < V(kLeastCurved), x, signed_as(V(0.5) * logarithm_of(q), x));
}

}  // namespace numbers
