#pragma once

#include "numbers/infinity.h"
#include "numbers/lane_arithmetic.h"
#include "numbers/low_degree_roots.h"
#include "numbers/safeguarded_newton.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace numbers {

inline constexpr int kMostPolynomialDegree = 35;
using PolynomialCoefficients = std::array<double, kMostPolynomialDegree + 1>;  ///< of powers of t, lowest first

namespace detail {

/// A polynomial and its slope at t.
inline void evaluate(const double* c, int degree, double t, double& value, double& slope)
{
    value = c[degree];
    slope = 0.0;
    for (int i = degree; i-- > 0;) {
        slope = slope * t + value;
        value = value * t + c[i];
    }
}

/// More than bisection of any bracket would need.
inline constexpr int kMostLooks = 300;

/// The sign change of a polynomial between lo and hi, from `t` on, until it moves by less than `close` of itself.
inline double bracketed(const double* c, int degree, double lo, double hi, bool negative_at_lo, double t, double close)
{
    const auto at = [=](double place) {
        ValueAndSlope here{};
        evaluate(c, degree, place, here.value, here.slope);
        return here;
    };
    return safeguarded_newton<true>(at, lo, hi, negative_at_lo, t, {0.0, close}, kMostLooks);
}

/// No root, nor one of a derivative, is larger by amount (Fujiwara 1916: twice the largest |c[n - k] / c[n]|^(1/k)),
/// from exponents alone. Of one polynomial or of one a lane.
template <class V>
inline V root_bound(const V* c, int degree)
{
    using std::ceil;
    const V last = c[degree];
    V most(-1100.0);
    lanes::Truth<V> endless = !(last == last);
    for (int k = 1; k <= degree; ++k) {
        const V ratio = lanes::size_of(c[degree - k] / last);
        endless = endless | !(ratio < V(kInfinity));
        const V power = (exponent_of(ratio) + V(1.0)) / V(static_cast<double>(k));
        most = lanes::choose(ratio > V(0.0), lanes::larger(most, power), most);
    }
    return lanes::choose(endless, V(kInfinity), V(2.0) * power_of_two(ceil(most)));
}

/// Sign changes of c[0] + ... + c[degree] t^degree in (lo, hi), in order: between two roots of its derivative a
/// polynomial changes its sign at most once, so from the parabola upwards.
inline int roots_by_turns(const double* c, int degree, double lo, double hi, double* out)
{
    constexpr int kMost = kMostPolynomialDegree;
    double derivative[kMost + 1], turns[kMost + 1];
    int count = 0;
    const auto keep = [&](double t) {
        if (t > lo && t < hi) out[count++] = t;
    };
    for (int order = std::max(0, degree - 2); order >= 0; --order) {
        const int n = degree - order;
        // The derivative of this order, over its factorial: only signs and roots matter.
        double binomial = 1.0;
        for (int i = 0; i <= n; ++i) {
            derivative[i] = c[i + order] * binomial;
            binomial = binomial * (i + 1 + order) / (i + 1);
        }
        if (n == 1) {
            keep(-derivative[0] / derivative[1]);
            continue;
        }
        if (n == 2) {
            const double half = 0.5 * derivative[1], discriminant = half * half - derivative[0] * derivative[2];
            if (!(discriminant > 0.0)) continue;
            const double q = -(half + std::copysign(std::sqrt(discriminant), half));
            const double a = derivative[0] / q, b = q / derivative[2];
            keep(std::min(a, b));
            keep(std::max(a, b));
            continue;
        }
        std::copy(out, out + count, turns);
        const int pieces = count;
        count = 0;
        double from = lo, unused = 0.0, before = 0.0;
        evaluate(derivative, n, from, before, unused);
        for (int i = 0; i <= pieces; ++i) {
            const double to = i < pieces ? turns[i] : hi;
            double after = 0.0;
            evaluate(derivative, n, to, after, unused);
            if ((before < 0.0) != (after < 0.0) && count < kMost) {
                // Where a turn lies needs no more than half of the digits: its value is off by the square.
                const double close = order > 0 ? 1e-9 : 1e-16;
                // Outside of all turns Newton comes from the far end without a step too far.
                const double start = pieces == 0   ? 0.5 * (from + to)
                                     : i == 0      ? from
                                     : i == pieces ? to
                                                   : 0.5 * (from + to);
                out[count++] = bracketed(derivative, n, from, to, before < 0.0, start, close);
            }
            from = to;
            before = after;
        }
    }
    return count;
}

/// A power of two with half of the roots on either side of it, roughly: where no term of a power above the middle one
/// is larger than all below, nor the other way round (an edge of the Newton polygon).
inline double middle_of_roots(const PolynomialCoefficients& c, int degree)
{
    const double middle = 0.5 * degree;
    double highest = -kInfinity, slope = 0.0;
    for (int i = 0; 2 * i < degree; ++i)
        for (int k = degree; 2 * k >= degree; --k) {
            const double low = std::abs(c[static_cast<std::size_t>(i)]),
                         high = std::abs(c[static_cast<std::size_t>(k)]);
            if (!(low > 0.0 && high > 0.0)) continue;
            const double rise = (static_cast<double>(std::ilogb(high)) - std::ilogb(low)) / (k - i);
            const double there = std::ilogb(low) + rise * (middle - i);
            if (!(there > highest)) continue;
            highest = there;
            slope = rise;
        }
    return std::ldexp(1.0, -static_cast<int>(std::lround(slope)));
}

/// Roots of so different sizes that the powers of one range do not fit a double: those far from 0 are the inverses of
/// the roots of the polynomial with its coefficients in the opposite order.
inline int far_and_near_roots(const PolynomialCoefficients& c, int degree, double* out)
{
    PolynomialCoefficients reversed{};
    std::reverse_copy(c.begin(), c.begin() + degree + 1, reversed.begin());
    double middle = middle_of_roots(c, degree);
    const auto sides_agree = [&](double t) {
        double value = 0.0, far_value = 0.0, unused = 0.0;
        evaluate(c.data(), degree, t, value, unused);
        evaluate(reversed.data(), degree, 1.0 / t, far_value, unused);
        return (value < 0.0) == ((far_value < 0.0) != (t < 0.0 && degree % 2 == 1));
    };
    // A root on the border would be counted by both sides or by none.
    for (int i = 0; i < 8 && !(sides_agree(middle) && sides_agree(-middle)); ++i) middle *= 1.125;
    double far[kMostPolynomialDegree];
    const int beyond = roots_by_turns(reversed.data(), degree, -1.0 / middle, 1.0 / middle, far);
    int negative = 0, count = 0;
    while (negative < beyond && far[negative] < 0.0) ++negative;
    for (int i = negative; i-- > 0;) out[count++] = 1.0 / far[i];
    double near[kMostPolynomialDegree];
    const int within = roots_by_turns(c.data(), degree, -middle, middle, near);
    for (int i = 0; i < within && count < degree; ++i) out[count++] = near[i];
    for (int i = beyond; i-- > negative && count < degree;) out[count++] = 1.0 / far[i];
    return count;
}

}  // namespace detail

/// Where c[0] + c[1] t + ... + c[degree] t^degree changes its sign, in order: at most `degree` places. c[degree] is not
/// 0.
inline int sign_changes(const PolynomialCoefficients& c, int degree, double (&out)[kMostPolynomialDegree])
{
    const int by_formula = degree == 4   ? detail::quartic_roots(c.data(), out)
                           : degree == 3 ? detail::cubic_roots(c.data(), out)
                                         : detail::kUnsure;
    if (by_formula != detail::kUnsure) return by_formula;
    const double bound = detail::root_bound(c.data(), degree);
    if (!(bound < kInfinity)) return 0;
    // The largest term at the bound is the leading one; binomials of the derivatives add 33 bits.
    constexpr int kMostExponent = 980;
    const double exponent = std::ilogb(c[static_cast<std::size_t>(degree)]) +
                            static_cast<double>(degree) * std::ilogb(bound);  // of a bound of 0: the least integer
    if (exponent > kMostExponent) return detail::far_and_near_roots(c, degree, out);
    return detail::roots_by_turns(c.data(), degree, -bound, bound, out);
}

}  // namespace numbers
