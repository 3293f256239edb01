#pragma once

#include "numbers/lane_arithmetic.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

/// Powers of one number or of numbers in lanes, by sums and products alone: the same bits for both and for every
/// instruction set, which neither the C library's nor xsimd's fused ones give. T is double or lanes::Double.
namespace numbers::lanes {

using Words = xsimd::batch<std::uint64_t>;

inline std::uint64_t words_of(double v) { return std::bit_cast<std::uint64_t>(v); }
inline double number_of(std::uint64_t v) { return std::bit_cast<double>(v); }
inline Words words_of(const Double& v) { return same_bits<Words>(v); }
inline Double number_of(const Words& v) { return same_bits<Double>(v); }

/// c[0] + c[1] x + c[2] x^2 + ..., by halves: a chain of products as long as the logarithm of their number (Estrin).
template <std::size_t First, std::size_t Count, class T, std::size_t N>
inline T polynomial(const std::array<double, N>& c, const T* squares)
{
    if constexpr (Count == 1) {
        return T(c[First]);
    } else {
        constexpr std::size_t kHalf = std::bit_floor(Count - 1);
        constexpr auto kPower = static_cast<std::size_t>(std::countr_zero(kHalf));
        return polynomial<First, kHalf>(c, squares) +
               squares[kPower] * polynomial<First + kHalf, Count - kHalf>(c, squares);
    }
}
/// Of the first `Count` coefficients.
template <std::size_t Count, class T, std::size_t N>
inline T polynomial(const std::array<double, N>& c, const T& x)
{
    T squares[4] = {x};
    for (int k = 1; k < 4; ++k) squares[k] = squares[k - 1] * squares[k - 1];
    static_assert(Count <= N && N <= 16);
    return polynomial<0, Count>(c, squares);
}
template <class T, std::size_t N>
inline T polynomial(const std::array<double, N>& c, const T& x)
{
    return polynomial<N>(c, x);
}

inline constexpr double kLn2High = 0x1.62e42fefa38p-1,
                        kLn2Low = 0x1.ef35793c7673p-45;  // the high part times an exponent is exact

/// A normal positive number as mantissa 2^exponent, the mantissa between the roots of 1/2 and 2.
template <class T>
struct Scaled {
    T mantissa, exponent;
};
template <class T>
inline Scaled<T> scaled(const T& c)
{
    constexpr std::uint64_t kRoot = 0x3fe6a09e667f3bcdu;  // of 1/2
    constexpr std::uint64_t kBias = std::uint64_t{1023} << 52;
    using W = decltype(words_of(c));
    const W steps = (words_of(c) + W(kBias - kRoot)) >> 52;  // the exponent, 1023 added
    const T e = number_of(steps | W(std::uint64_t{0x433} << 52)) - T(4503599627370496.0 + 1023.0);  // 2^52: as a number
    return {number_of(words_of(c) - ((steps - W(1023)) << 52)), e};
}

/// The logarithm of a scaled number by 2 artanh(f), f = (m - 1) / (m + 1) of its mantissa, and so many terms behind the
/// first.
template <std::size_t kTerms, class T>
inline T logarithm_by(const T& f, const T& exponent)
{
    constexpr std::array<double, 10> kOdd = {1.0 / 3,  1.0 / 5,  1.0 / 7,  1.0 / 9,  1.0 / 11,
                                             1.0 / 13, 1.0 / 15, 1.0 / 17, 1.0 / 19, 1.0 / 21};
    const T s = f * f;
    return exponent * T(kLn2High) + (exponent * T(kLn2Low) + T(2.0) * (f + f * s * polynomial<kTerms>(kOdd, s)));
}

/// ln c of normal positive numbers; within 2 units in the last place where c is not 1.
template <class T>
inline T logarithm(const T& c)
{
    const auto [m, e] = scaled(c);
    return logarithm_by<10>((m - T(1.0)) / (m + T(1.0)), e);
}

/// e^y for -700 <= y <= 700, by its series about the nearest power of 2; with 7 terms it is off by 3e-10 of itself.
template <std::size_t kTerms = 12, class T>
inline T exponential(const T& y)
{
    constexpr std::array<double, 12> kTaylor = {1.0 / 2,       1.0 / 6,        1.0 / 24,        1.0 / 120,
                                                1.0 / 720,     1.0 / 5040,     1.0 / 40320,     1.0 / 362880,
                                                1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};
    constexpr double kRound = 6755399441055744.0;  // 1.5 2^52: what is added to it loses its fraction
    const T shifted = y * T(0x1.71547652b82fep0) + T(kRound), k = shifted - T(kRound);
    const T r = (y - k * T(kLn2High)) - k * T(kLn2Low);
    const T sum = T(1.0) + (r + r * r * polynomial<kTerms>(kTaylor, r));
    return number_of(words_of(sum) + (words_of(shifted) << 52));
}

/// c^n for normal c in (0, 2], n >= 0, as far as it is not above e^700; what is below e^-700 is that.
template <class T>
inline T power(const T& c, const T& n)
{
    const T y = n * logarithm(c), least(-700.0);
    return exponential(choose(y > least, y, least));
}

}  // namespace numbers::lanes
