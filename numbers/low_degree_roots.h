#pragma once

#include "numbers/quartic_factors.h"

#include <algorithm>
#include <limits>

/// Real roots of cubics and quartics by formula, polished. Each says when it cannot be sure: near tangents, where roots
/// differ much in size, where coefficients are no numbers.
namespace csg::detail {

inline constexpr int kUnsure = -1;

/// The power of two that brings a number of this size to about 1; 1 for 0.
inline int exponent_of(double v) { return static_cast<int>(std::bit_cast<std::uint64_t>(v) >> 52 & 0x7ff) - 1023; }
inline double power_of_two(int n)
{
    return std::bit_cast<double>(static_cast<std::uint64_t>(std::clamp(n, -1022, 1023) + 1023) << 52);
}

/// A quartic about the middle of its roots, scaled so that they are of order 1.
struct DepressedQuartic {
    double square, linear, constant;
    void sheets(double t, double& value, double& slope) const
    {
        value = constant + t * (linear + t * (square + t * t));
        slope = linear + t * (2.0 * square + t * t * 4.0);
    }
};

/// The middle of the roots may be so many times farther from 0 than they are from it: more loses the digits that the
/// sureness of a tangent needs (1e-16 times its fourth power against 1e-6).
inline constexpr double kFarthestMiddle = 100.0;

/// One more step on the coefficients as given, and whether the roots still stand apart.
inline int finish_roots(const double* c, int degree, double scale, double shift, double* roots, int count)
{
    for (int i = 0; i < count; ++i) {
        const double t = roots[i] * scale - shift;
        double value = c[degree], slope = 0.0;
        for (int k = degree; k-- > 0;) {
            slope = slope * t + value;
            value = value * t + c[k];
        }
        const double step = value / slope;
        if (!(std::abs(step) <= 1e-6 * scale)) return kUnsure;
        roots[i] = t - step;
        if (i > 0 && !(roots[i] > roots[i - 1])) return kUnsure;
    }
    return count;
}

/// c[0] + ... + c[4] t^4 = 0 in order. kUnsure, or how many.
inline int quartic_roots(const double* c, double* out)
{
    const double inverse = 1.0 / c[4], a0 = c[0] * inverse, a1 = c[1] * inverse, a2 = c[2] * inverse,
                 s = 0.25 * c[3] * inverse, s2 = s * s;
    const double square = a2 - 6.0 * s2, linear = a1 - 2.0 * s * (a2 - 4.0 * s2),
                 constant = a0 + s * (s * (a2 - 3.0 * s2) - a1);
    if (!(std::abs(square) + std::abs(linear) + std::abs(constant) < 1e200)) return kUnsure;
    // Floors: a size too small scales roots up, never past what fits.
    const int e = std::max({exponent_of(square) >> 1, exponent_of(linear) / 3, exponent_of(constant) >> 2});
    if (e < -100) return kUnsure;
    const double size = power_of_two(e + 1), k = power_of_two(-e - 1), k2 = k * k;
    if (std::abs(s) > kFarthestMiddle * size) return kUnsure;
    const auto found = quartic_by_factors<double>(DepressedQuartic{square * k2, linear * k2 * k, constant * k2 * k2});
    if (!found.safe) return kUnsure;
    const int count = found.four ? 4 : found.two ? 2 : 0;
    std::copy_n(found.roots, count, out);
    return finish_roots(c, 4, size, s, out, count);
}

/// The same for c[0] + ... + c[3] t^3.
inline int cubic_roots(const double* c, double* out)
{
    constexpr double kTangent = 1e-6;
    const double inverse = 1.0 / c[3], a0 = c[0] * inverse, a1 = c[1] * inverse, s = c[2] * inverse / 3.0;
    const double linear = a1 - 3.0 * s * s, constant = a0 + s * (2.0 * s * s - a1);
    if (!(std::abs(linear) + std::abs(constant) < 1e200)) return kUnsure;
    const int e = std::max(exponent_of(linear) >> 1, exponent_of(constant) / 3);
    if (e < -100) return kUnsure;
    const double size = power_of_two(e + 1), k = power_of_two(-e - 1);
    if (std::abs(s) > kFarthestMiddle * size) return kUnsure;
    const double p = linear * k * k, q = constant * k * k * k;
    const double r = largest_root(0.0, p, -std::abs(q));  // of the mirrored cubic, if q is positive
    const double below = -(p + 0.75 * r * r);             // the square of the others' distance from their middle
    if (!(std::abs(below) > kTangent * (std::abs(p) + r * r))) return kUnsure;
    const double side = q > 0.0 ? -1.0 : 1.0;
    int count = 0;
    if (below > 0.0) {
        const double reach = std::sqrt(below);
        out[count++] = side * -0.5 * r - reach;
        out[count++] = side * -0.5 * r + reach;
    }
    out[count++] = side * r;
    std::sort(out, out + count);
    return finish_roots(c, 3, size, s, out, count);
}

}  // namespace csg::detail
