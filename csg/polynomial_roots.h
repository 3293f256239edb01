#pragma once

// Continues polynomial_shape.h: the root finder, inline because it is compiled once per instruction set.
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

/// The sign change between lo and hi: Newton, kept inside the bracket by bisection.
inline double bracketed(const double* c, int degree, double lo, double hi, bool negative_at_lo)
{
    double t = 0.5 * (lo + hi);
    for (int i = 0; i < 120; ++i) {
        double value = 0.0, slope = 0.0;
        evaluate(c, degree, t, value, slope);
        if (value == 0.0) return t;
        ((value < 0.0) == negative_at_lo ? lo : hi) = t;
        double next = t - value / slope;
        if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
        if (std::abs(next - t) <= 1e-16 * std::abs(t) || next == lo || next == hi) return next;
        t = next;
    }
    return t;
}

}  // namespace detail

inline int sign_changes(const PolynomialShape::Along& c, int degree, double (&out)[PolynomialShape::kMostDegree])
{
    constexpr int kMost = PolynomialShape::kMostDegree;
    // Between two roots of its derivative a polynomial changes its sign at most once: from the straight line upwards.
    double derivative[kMost + 1];
    double bound = 0.0;   // Cauchy's, of all roots and so of the derivatives' too
    for (int i = 0; i < degree; ++i) bound = std::max(bound, std::abs(c[static_cast<std::size_t>(i)]));
    bound = 1.0 + bound / std::abs(c[static_cast<std::size_t>(degree)]);
    if (!(bound < 1e300)) return 0;
    int count = 0;
    double turns[kMost + 1];
    for (int order = degree - 1; order >= 0; --order) {
        const int n = degree - order;
        // The derivative of this order, over its factorial: only signs and roots matter.
        double binomial = 1.0;
        for (int i = 0; i <= n; ++i) {
            derivative[i] = c[static_cast<std::size_t>(i + order)] * binomial;
            binomial = binomial * (i + 1 + order) / (i + 1);
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
            if ((before < 0.0) != (after < 0.0) && count < kMost) out[count++] = detail::bracketed(derivative, n, lo, hi, before < 0.0);
            lo = hi;
            before = after;
        }
    }
    return count;
}

}  // namespace csg
