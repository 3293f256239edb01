#pragma once

#include "numbers/lane_power.h"

#include <cmath>
#include <type_traits>

/// Numbers of twice the precision as sums of two, for a double or lanes of them. Nothing here rounds other than as
/// written: what a processor fuses is fused only where its result is exact, so all machines agree to the last bit.
namespace numbers {

using lanes::choose;
using lanes::Double;
using lanes::number_of;
using lanes::signed_as;
using lanes::size_of;
using lanes::words_of;

/// high + low, where low is smaller than high by the precision of a double, if not said otherwise.
template <class V>
struct Pair {
    V high, low;
};

/// a + b, exactly (Knuth).
template <class V>
constexpr Pair<V> exact_sum(const V& a, const V& b)
{
    const V s = a + b, t = s - a;
    return {s, (a - (s - t)) + (b - t)};
}
/// The same where a is 0 or not smaller than b (Dekker).
template <class V>
constexpr Pair<V> ordered_sum(const V& a, const V& b)
{
    const V s = a + b;
    return {s, b - (s - a)};
}

/// The first 26 bits of a number: a product of two such is exact.
template <class V>
inline V top(const V& v)
{
    using W = decltype(words_of(v));
    return number_of(words_of(v) & W(~std::uint64_t{0x7ffffff}));
}

/// a b, exactly (Dekker's halves by Veltkamp), for sizes below 2^990 of which nothing falls below 2^-1022.
template <class V>
constexpr Pair<V> exact_product(const V& a, const V& b)
{
    const V p = a * b;
#if defined(__FMA__)
    if (!std::is_constant_evaluated()) return {p, lanes::fused(a, b, V(0.0) - p)};
#endif
    const V c = a * V(134217729.0), d = b * V(134217729.0);  // 2^27 + 1
    const V ah = c - (c - a), bh = d - (d - b), al = a - ah, bl = b - bh;
    return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

template <class V>
constexpr Pair<V> operator+(const Pair<V>& a, const Pair<V>& b)
{
    const Pair<V> s = exact_sum(a.high, b.high);
    return ordered_sum(s.high, s.low + (a.low + b.low));
}
template <class V>
constexpr Pair<V> operator*(const Pair<V>& a, const Pair<V>& b)
{
    const Pair<V> p = exact_product(a.high, b.high);
    return ordered_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}
template <class V>
constexpr Pair<V> operator/(const Pair<V>& n, const Pair<V>& d)
{
    const V inverse = V(1.0) / d.high, q = n.high * inverse;
    const Pair<V> p = exact_product(q, d.high);
    return ordered_sum(q, (((n.high - p.high) - p.low) + (n.low - q * d.low)) * inverse);
}
template <class V>
inline Pair<V> root_of(const Pair<V>& v)
{
    const V r = lanes::root_of(v.high);
    const Pair<V> p = exact_product(r, r);
    const V rest = ((v.high - p.high) - p.low) + v.low;
    return {r, choose(r == V(0.0), V(0.0), rest / (r + r))};
}

template <std::size_t Rows, std::size_t Columns>
using Table = std::array<std::array<double, Columns>, Rows>;

/// A column of a row, or of one a lane.
template <std::size_t Column, std::size_t Rows, std::size_t Columns>
inline double column(const Table<Rows, Columns>& table, std::uint64_t row)
{
    return table[row][Column];
}
template <std::size_t Column, std::size_t Rows, std::size_t Columns>
inline Double column(const Table<Rows, Columns>& table, const lanes::Words& row)
{
    return lanes::gathered(table[0].data() + Column, row << std::countr_zero(Columns));
}

}  // namespace numbers
