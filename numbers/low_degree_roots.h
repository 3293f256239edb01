#pragma once

#include "numbers/quartic_factors.h"

#include <algorithm>
#include <cmath>
#include <limits>

/// Real roots of cubics and quartics by formula, polished. Each says when it cannot be sure: near tangents, where roots
/// differ much in size, where coefficients are no numbers.
namespace numbers::detail {

inline constexpr int kUnsure = -1;

/// The power of two that brings a number of this size to about 1 and its exponent, one number's or those of lanes.
inline double exponent_of(double v)
{
    return static_cast<double>(static_cast<int>(std::bit_cast<std::uint64_t>(v) >> 52 & 0x7ff) - 1023);
}
inline double power_of_two(double n)
{
    return std::bit_cast<double>(static_cast<std::uint64_t>(std::clamp(n, -1022.0, 1023.0) + 1023.0) << 52);
}
/// Whole numbers below 2^52 stand in the last bits of what 2^52 is added to.
inline constexpr double kWhole = 0x1p52;
inline lanes::Double exponent_of(const lanes::Double& v)
{
    using Bits = xsimd::batch<std::uint64_t>;
    const Bits power = lanes::same_bits<Bits>(xsimd::abs(v)) >> 52,
               whole = power | lanes::same_bits<Bits>(lanes::Double(kWhole));
    return lanes::same_bits<lanes::Double>(whole) - lanes::Double(kWhole + 1023.0);
}
inline lanes::Double power_of_two(const lanes::Double& n)
{
    using Bits = xsimd::batch<std::uint64_t>;
    const lanes::Double held = xsimd::min(xsimd::max(n, lanes::Double(-1022.0)), lanes::Double(1023.0));
    return lanes::same_bits<lanes::Double>(lanes::same_bits<Bits>(held + lanes::Double(kWhole + 1023.0)) << 52);
}

/// A quartic about the middle of its roots, scaled so that they are of order 1.
template <class V>
struct DepressedQuartic {
    V square, linear, constant;
    void sheets(V t, V& value, V& slope) const
    {
        value = constant + t * (linear + t * (square + t * t));
        slope = linear + t * (V(2.0) * square + t * t * V(4.0));
    }
};

/// The middle of the roots may be so many times farther from 0 than they are from it: more loses the digits that the
/// sureness of a tangent needs (1e-16 times its fourth power against 1e-6).
inline constexpr double kFarthestMiddle = 100.0;

/// A root as found, back where it was and one more step nearer on the coefficients as given. False: it was none.
template <class V>
inline lanes::Truth<V> finish_root(const V* c, int degree, const V& scale, const V& shift, V& root)
{
    const V t = root * scale - shift;
    V value = c[degree], slope(0.0);
    for (int k = degree; k-- > 0;) {
        slope = slope * t + value;
        value = value * t + c[k];
    }
    const V step = value / slope;
    root = t - step;
    return lanes::size_of(step) <= V(1e-6) * scale;
}

/// c[0] + ... + c[4] t^4 = 0; the roots still stand apart where it is safe.
template <class V>
inline QuarticFactors<V> quartic_factors(const V* c)
{
    using std::floor, std::trunc;
    const V inverse = V(1.0) / c[4], a0 = c[0] * inverse, a1 = c[1] * inverse, a2 = c[2] * inverse,
            s = V(0.25) * c[3] * inverse, s2 = s * s;
    const V square = a2 - V(6.0) * s2, linear = a1 - V(2.0) * s * (a2 - V(4.0) * s2),
            constant = a0 + s * (s * (a2 - V(3.0) * s2) - a1);
    const lanes::Truth<V> fits = lanes::size_of(square) + lanes::size_of(linear) + lanes::size_of(constant) < V(1e200);
    // Floors: a size too small scales roots up, never past what fits.
    const V e = lanes::larger(lanes::larger(floor(exponent_of(square) * V(0.5)), trunc(exponent_of(linear) / V(3.0))),
                              floor(exponent_of(constant) * V(0.25)));
    const V size = power_of_two(e + V(1.0)), k = power_of_two(V(-1.0) - e), k2 = k * k;
    const lanes::Truth<V> large = e >= V(-100.0), near = lanes::size_of(s) <= V(kFarthestMiddle) * size,
                          known = fits & large & near;
    QuarticFactors<V> out;
    out.safe = out.two = out.four = known;
    if (lanes::mask(known) == 0) return out;
    out = quartic_by_factors<V>(DepressedQuartic<V>{square * k2, linear * k2 * k, constant * k2 * k2});
    out.safe = out.safe & known;
    for (std::size_t i = 0; i < 4; ++i) {
        const lanes::Truth<V> there = i < 2 ? out.two : out.four;
        if (lanes::mask(there) == 0) break;
        lanes::Truth<V> found = finish_root(c, 4, size, s, out.roots[i]);
        if (i > 0) {
            const lanes::Truth<V> apart = out.roots[i] > out.roots[i - 1];
            found = found & apart;
        }
        out.safe = out.safe & ((!there) | found);
    }
    return out;
}

/// In order. kUnsure, or how many.
inline int quartic_roots(const double* c, double* out)
{
    const QuarticFactors<double> found = quartic_factors(c);
    if (!found.safe) return kUnsure;
    const int count = found.four ? 4 : found.two ? 2 : 0;
    std::copy_n(found.roots, count, out);
    return count;
}

/// The same for c[0] + ... + c[3] t^3.
inline int cubic_roots(const double* c, double* out)
{
    constexpr double kTangent = 1e-6;
    const double inverse = 1.0 / c[3], a0 = c[0] * inverse, a1 = c[1] * inverse, s = c[2] * inverse / 3.0;
    const double linear = a1 - 3.0 * s * s, constant = a0 + s * (2.0 * s * s - a1);
    if (!(std::abs(linear) + std::abs(constant) < 1e200)) return kUnsure;
    const double e = std::max(std::floor(exponent_of(linear) / 2.0), std::trunc(exponent_of(constant) / 3.0));
    if (e < -100.0) return kUnsure;
    const double size = power_of_two(e + 1.0), k = power_of_two(-e - 1.0);
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
    for (int i = 0; i < count; ++i)
        if (!finish_root(c, 3, size, s, out[i]) || (i > 0 && !(out[i] > out[i - 1]))) return kUnsure;
    return count;
}

}  // namespace numbers::detail
