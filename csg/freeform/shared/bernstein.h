#pragma once

#include "csg/base/numbers.h"
#include "numbers/polynomial_roots.h"
#include "numbers/safeguarded_newton.h"

#include <array>
#include <functional>

/// Polynomials on [0, 1] by their Bernstein ordinates: the first and the last are the values at the ends, and no value
/// lies outside of them all (Farin, Curves and Surfaces for CAGD, 4). An array of n + 1 ordinates is one of degree n.
namespace csg {

namespace detail {

/// The binomial coefficient n over k.
constexpr double choose(std::size_t n, std::size_t k)
{
    double ways = 1.0;
    for (std::size_t i = 0; i < k; ++i) ways = ways * static_cast<double>(n - i) / static_cast<double>(i + 1);
    return ways;
}

/// Value and slope at t (de Casteljau).
template <std::size_t count>
inline void casteljau(std::array<double, count> b, double t, double& value, double& slope)
{
    for (std::size_t left = count - 1; left > 1; --left)
        for (std::size_t i = 0; i < left; ++i) b[i] += t * (b[i + 1] - b[i]);
    slope = static_cast<double>(count - 1) * (b[1] - b[0]);
    value = b[0] + t * (b[1] - b[0]);
}

/// The roots of a quadratic in order; of no use where they are complex, NaN for a constant.
inline void quadratic_roots(const std::array<double, 3>& b, double (&roots)[2])
{
    const double half = b[1] - b[0], a = b[0] - 2.0 * b[1] + b[2];
    const double q = -(half + std::copysign(std::sqrt(std::max(half * half - a * b[0], 0.0)), half));
    const double s = q / a, t = b[0] / q;
    roots[0] = std::min(s, t);
    roots[1] = std::max(s, t);
}

/// The coefficients of a quartic, the lowest first, from its ordinates. Number is double or a vector of lanes.
template <class Number>
inline std::array<Number, 5> quartic_powers(const std::array<Number, 5>& b)
{
    const Number two(2.0), three(3.0), four(4.0), six(6.0);
    return {b[0], four * (b[1] - b[0]), six * (b[2] - two * b[1] + b[0]),
            four * (b[3] - three * b[2] + three * b[1] - b[0]), b[4] - four * b[3] + six * b[2] - four * b[1] + b[0]};
}

inline constexpr double kClosePlace = 1e-15;  ///< relative error of a quartic's root: a few units in the last place

/// The root in [0, 1] of a polynomial whose ordinates change sign once.
template <std::size_t count>
inline double only_change(const std::array<double, count>& b)
{
    const double last = b[count - 1], chord = b[0] / (b[0] - last);
    double t = chord > 0.0 && chord < 1.0 ? chord : 0.5;
    if constexpr (count == 2) {
        return t;
    } else if constexpr (count == 3) {
        double roots[2];
        quadratic_roots(b, roots);
        // The other root lies outside, if only by rounding.
        const bool first = std::abs(roots[0] - 0.5) <= std::abs(roots[1] - 0.5);
        return std::min(std::max(first ? roots[0] : roots[1], 0.0), 1.0);
    } else if constexpr (count == 5) {
        return bracketed(quartic_powers(b).data(), 4, 0.0, 1.0, b[0] <= 0.0, t, kClosePlace);
    } else {
        constexpr double kClose = 1e-9;  // relative to the interval: Newton's last step doubles the digits
        const auto at = [&b](double place) {
            ValueAndSlope here{};
            casteljau(b, place, here.value, here.slope);
            return here;
        };
        return safeguarded_newton(at, 0.0, 1.0, !(b[0] > 0.0), t, {kClose, 0.0});
    }
}

}  // namespace detail

/// The product of two polynomials; `times` multiplies two ordinates, which may be vectors.
template <class T, std::size_t n, std::size_t m, class Times = std::multiplies<T>>
inline std::array<double, n + m - 1> product(const std::array<T, n>& a, const std::array<T, m>& b, Times&& times = {})
{
    static constexpr auto kShare = [] {
        std::array<std::array<double, m>, n> share{};
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = 0; k < m; ++k)
                share[i][k] = detail::choose(n - 1, i) * detail::choose(m - 1, k) / detail::choose(n + m - 2, i + k);
        return share;
    }();
    std::array<double, n + m - 1> all{};
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < m; ++k) all[i + k] += kShare[i][k] * times(a[i], b[k]);
    return all;
}

/// The ordinates of a polynomial from its coefficients, the lowest first.
template <std::size_t count>
inline std::array<double, count> ordinates_of(const double* powers)
{
    static constexpr auto kWays = [] {
        std::array<double, count> ways{};
        for (std::size_t i = 0; i < count; ++i) ways[i] = detail::choose(count - 1, i);
        return ways;
    }();
    std::array<double, count> b;
    for (std::size_t i = 0; i < count; ++i) b[i] = powers[i] / kWays[i];
    for (std::size_t k = 1; k < count; ++k)
        for (std::size_t i = count - 1; i >= k; --i) b[i] += b[i - 1];
    return b;
}

/// The derivative.
template <std::size_t n>
inline std::array<double, n - 1> derivative(const std::array<double, n>& b)
{
    std::array<double, n - 1> d;
    for (std::size_t i = 0; i + 1 < n; ++i) d[i] = static_cast<double>(n - 1) * (b[i + 1] - b[i]);
    return d;
}

/// The polynomial on [0, 1/2] and on [1/2, 1].
template <class T, std::size_t count>
inline void halve(const std::array<T, count>& b, std::array<T, count>& left, std::array<T, count>& right)
{
    right = b;
    for (std::size_t k = 0; k < count; ++k) {
        left[k] = right[0];
        for (std::size_t i = 0; i + k + 1 < count; ++i) right[i] = 0.5 * (right[i] + right[i + 1]);
    }
}

/// How often the sign changes along the ordinates: at least as often as the polynomial's own in (0, 1), and odd where
/// that is odd (Descartes). What is not positive counts as negative, NaN too.
template <std::size_t count>
inline int ordinate_changes(const std::array<double, count>& b)
{
    int changes = 0;
    for (std::size_t i = 0; i + 1 < count; ++i) changes += (b[i] > 0.0) != (b[i + 1] > 0.0) ? 1 : 0;
    return changes;
}

inline constexpr int kHalvings = 40;  ///< a fit `depth`: two changes nearer than 2^-40 of the interval count as a touch

/// Calls found(t) in order where the polynomial, here on [low, high], changes its sign between positive and not; false
/// from it ends the search. Halves the interval until one change at most is left, `depth` times; two nearer than that
/// are not told.
template <std::size_t count, class F>
inline bool each_change(const std::array<double, count>& b, double low, double high, int depth, F&& found)
{
    const int changes = ordinate_changes(b);
    if (changes == 0) return true;
    if (changes == 1) return found(low + (high - low) * detail::only_change(b));
    if constexpr (count == 3) {  // two changes: both roots are in it, if there are any
        double roots[2];
        detail::quadratic_roots(b, roots);
        if (!((b[1] - b[0]) * (b[1] - b[0]) > (b[0] - 2.0 * b[1] + b[2]) * b[0])) return true;
        return found(low + (high - low) * roots[0]) && found(low + (high - low) * roots[1]);
    }
    const double middle = 0.5 * (low + high);
    if (depth == 0) return (changes & 1) == 0 || found(middle);
    std::array<double, count> left, right;
    halve(b, left, right);
    return each_change(left, low, middle, depth - 1, found) && each_change(right, middle, high, depth - 1, found);
}

}  // namespace csg
