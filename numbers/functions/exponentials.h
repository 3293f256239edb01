#pragma once

#include "numbers/functions/functions.h"
#include "numbers/functions/tables.h"

/// Exponential and hyperbolic functions: e^x is 2^(k / 128) of a table times e^r of an r below 0.003.
namespace numbers {

inline constexpr double kMostQuickExponent = 708.0;                      // e^x and e^-x are normal numbers
inline constexpr double kLeastExponent = -746.0, kMostExponent = 710.0;  // beyond them e^x is 0 and infinite

/// (high + low) 2^floor(step / 128); low is below 2^-8 of high. `step` counts in the number's low 51 bits.
template <class V, class W = decltype(words_of(std::declval<V>()))>
struct Scaled {
    V high, low;
    W step;
    W exponent() const { return (step >> 7) << 52; }
};

template <class V>
inline Scaled<V> exponential_of(const V& x, const V& x_low)
{
    constexpr double kSteps = 0x1.71547652b82fep+7;  // 128 / ln 2
    constexpr double kRound = 6755399441055744.0;
    constexpr double kPart[] = {0x1.62e42fefcp-8, -0x1.c610ca86c3899p-44};
    using W = decltype(words_of(x));
    const V shifted = x * V(kSteps) + V(kRound), k = shifted - V(kRound);
    const V r = ((x - k * V(kPart[0])) - k * V(kPart[1])) + x_low, q = r * r;
    const V p = r + q * ((V(1.0 / 2) + r * V(1.0 / 6)) + q * ((V(1.0 / 24) + r * V(1.0 / 120)) + q * V(1.0 / 720)));
    const W step = words_of(shifted), row = step & W(std::uint64_t{kPowerSteps - 1});
    const V t = column<0>(kPowers, row);
    return {t, column<1>(kPowers, row) + t * p, step};
}

/// Of a normal result.
template <class V, class W>
inline V quick_value(const Scaled<V, W>& of)
{
    return number_of(words_of(of.high + of.low) + of.exponent());
}
template <class V, class W>
inline Pair<V> quick_pair(const Scaled<V, W>& of)
{
    const V scale = number_of(of.exponent() + W(std::uint64_t{1023} << 52));
    return {of.high * scale, of.low * scale};
}

/// Of any size, rounded once.
inline double value(const Scaled<double>& of)
{
    const auto exponent = static_cast<std::int64_t>(of.step << 13) >> 20;
    if (exponent > 1100) return std::numeric_limits<double>::infinity();
    if (exponent < -1100) return 0.0;
    if (exponent > 0) return std::ldexp(of.high + of.low, static_cast<int>(exponent));
    if (exponent > -1021) return quick_value(of);
    // 2^1022 of it is added to 1 first, whose last bit is the last of what is kept.
    const int up = static_cast<int>(exponent) + 1022;
    const double high = std::ldexp(of.high, up), low = std::ldexp(of.low, up);
    if (const double sum = high + low; sum >= 1.0) return std::ldexp(sum, -1022);
    const Pair<double> one = exact_sum(1.0, high);
    return std::ldexp((one.high + (one.low + low)) - 1.0, -1022);
}

/// Twice the hyperbolic sine of x >= 0; rest as in a pair.
template <class V>
inline Pair<V> twice_sinh(const V& x, const Pair<V>& up, const Pair<V>& down)
{
    // The difference of exponentials would lose bits; the series needs few terms.
    constexpr double kSmall = 0.18;
    const V q = x * x;
    constexpr std::array<double, 6> kOdd = {2.0 / 6,      2.0 / 120,      2.0 / 5040,
                                            2.0 / 362880, 2.0 / 39916800, 2.0 / 6227020800};
    const Pair<V> series = ordered_sum(x + x, x * q * lanes::polynomial(kOdd, q));
    const Pair<V> sum = exact_sum(up.high, V(0.0) - down.high);
    const Pair<V> difference = ordered_sum(sum.high, sum.low + (up.low - down.low));
    const auto small = x < V(kSmall);
    return {choose(small, series.high, difference.high), choose(small, series.low, difference.low)};
}
template <class V>
inline Pair<V> twice_cosh(const Pair<V>& up, const Pair<V>& down)
{
    const Pair<V> sum = exact_sum(up.high, down.high);
    return ordered_sum(sum.high, sum.low + (up.low + down.low));
}

template <class V>
inline Pair<V> power_of_e(const V& x)
{
    return quick_pair(exponential_of(x, V(0.0)));
}
/// Both share the exponentials.
template <class V>
inline SineAndCosine<V> quick_hyperbolic(const V& x)
{
    const V a = size_of(x);
    const Pair<V> up = power_of_e(a), down = power_of_e(V(0.0) - a);
    return {signed_as(V(0.5) * twice_sinh(a, up, down).high, x), V(0.5) * twice_cosh(up, down).high};
}
template <class V>
inline V quick_sinh(const V& x)
{
    return quick_hyperbolic(x).sine;
}
template <class V>
inline V quick_cosh(const V& x)
{
    return quick_hyperbolic(x).cosine;
}
template <class V>
inline V quick_tanh(const V& x)
{
    const V size = size_of(x), a = choose(size < V(32.0), size, V(32.0));  // from 20 on it is 1
    const Pair<V> up = power_of_e(a), down = power_of_e(V(0.0) - a);
    return signed_as((twice_sinh(a, up, down) / twice_cosh(up, down)).high, x);
}

}  // namespace numbers
