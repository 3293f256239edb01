#pragma once

// Continues polynomial_shape.h: the root finder, inline because it is compiled once per instruction set.
#include "csg/low_degree_roots.h"
#include "csg/polynomial_shape.h"

#include <algorithm>
#include <cmath>

namespace csg {

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

/// The sign change between lo and hi, from `t` on: Newton, kept inside the bracket by bisection, until it moves by less
/// than `close` of itself.
inline double bracketed(const double* c, int degree, double lo, double hi, bool negative_at_lo, double t, double close)
{
    for (int i = 0; i < 120; ++i) {
        double value = 0.0, slope = 0.0;
        evaluate(c, degree, t, value, slope);
        if (value == 0.0) return t;
        ((value < 0.0) == negative_at_lo ? lo : hi) = t;
        double next = t - value / slope;
        if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
        if (std::abs(next - t) <= close * std::abs(t) || next == lo || next == hi) return next;
        t = next;
    }
    return t;
}

}  // namespace detail

namespace detail {

/// No root, nor one of a derivative, is larger by amount (Fujiwara 1916: twice the largest |c[n - k] / c[n]|^(1/k)), from
/// exponents alone.
inline double root_bound(const PolynomialShape::Along& c, int degree)
{
    const double last = c[static_cast<std::size_t>(degree)];
    double most = -1100.0;
    for (int k = 1; k <= degree; ++k) {
        const double ratio = std::abs(c[static_cast<std::size_t>(degree - k)] / last);
        if (!(ratio < kInfinity)) return kInfinity;
        if (ratio > 0.0) most = std::max(most, static_cast<double>(std::ilogb(ratio) + 1) / k);
    }
    return 2.0 * std::ldexp(1.0, static_cast<int>(std::ceil(most)));
}

}  // namespace detail

inline int sign_changes(const PolynomialShape::Along& c, int degree, double (&out)[PolynomialShape::kMostDegree])
{
    constexpr int kMost = PolynomialShape::kMostDegree;
    const int by_formula = degree == 4 ? detail::quartic_roots(c.data(), out) : degree == 3 ? detail::cubic_roots(c.data(), out) : detail::kUnsure;
    if (by_formula != detail::kUnsure) return by_formula;
    // Between two roots of its derivative a polynomial changes its sign at most once: from the parabola upwards.
    double derivative[kMost + 1];
    const double bound = detail::root_bound(c, degree);
    if (!(bound < 1e300)) return 0;
    int count = 0;
    double turns[kMost + 1];
    for (int order = std::max(0, degree - 2); order >= 0; --order) {
        const int n = degree - order;
        // The derivative of this order, over its factorial: only signs and roots matter.
        double binomial = 1.0;
        for (int i = 0; i <= n; ++i) {
            derivative[i] = c[static_cast<std::size_t>(i + order)] * binomial;
            binomial = binomial * (i + 1 + order) / (i + 1);
        }
        if (n == 1) {
            out[count++] = -derivative[0] / derivative[1];
            continue;
        }
        if (n == 2) {
            const double half = 0.5 * derivative[1], discriminant = half * half - derivative[0] * derivative[2];
            if (!(discriminant > 0.0)) continue;
            const double q = -(half + std::copysign(std::sqrt(discriminant), half));
            const double a = derivative[0] / q, b = q / derivative[2];
            out[0] = std::min(a, b);
            out[1] = std::max(a, b);
            count = 2;
            continue;
        }
        std::copy(out, out + count, turns);
        const int pieces = count;
        count = 0;
        double lo = -bound, unused = 0.0, before = 0.0;
        detail::evaluate(derivative, n, lo, before, unused);
        for (int i = 0; i <= pieces; ++i) {
            const double hi = i < pieces ? turns[i] : bound;
            double after = 0.0;
            detail::evaluate(derivative, n, hi, after, unused);
            if ((before < 0.0) != (after < 0.0) && count < kMost) {
                // Where a turn lies needs no more than half of the digits: its value is off by the square.
                const double close = order > 0 ? 1e-9 : 1e-16;
                // Outside of all turns Newton comes from the far end without a step too far.
                const double start = pieces == 0 ? 0.5 * (lo + hi) : i == 0 ? lo : i == pieces ? hi : 0.5 * (lo + hi);
                out[count++] = detail::bracketed(derivative, n, lo, hi, before < 0.0, start, close);
            }
            lo = hi;
            before = after;
        }
    }
    return count;
}

}  // namespace csg
