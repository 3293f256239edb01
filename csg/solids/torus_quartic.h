#pragma once

#include <glm/glm.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

/// A torus along a ray, and the quartic of its crossings solved by factors.
namespace csg::detail {

/// The torus along one ray, about the foot of the perpendicular from the centre, scaled so that lengths are near 1.
struct TorusRay {
    glm::dvec3 p, d;              ///< |d| = 1; dot(p, d) is 0 but for rounding, so the quartic has no cubic term
    double major, minor;
    double square = 0.0, linear = 0.0, constant = 0.0;  ///< t^4 + square t^2 + linear t + constant

    void expand()
    {
        const double k = glm::dot(p, p) - major * major - minor * minor, r2 = major * major;
        square = 2.0 * (k + 2.0 * r2 * d.y * d.y);
        linear = 8.0 * r2 * p.y * d.y;
        constant = k * k + 4.0 * r2 * (p.y - minor) * (p.y + minor);
    }
    double derivative(double t) const { return linear + t * (2.0 * square + t * t * 4.0); }

    /// The quartic as the product of its two sheets, evaluated on the surface's own terms: coefficients cannot carry
    /// the accuracy of a thin torus.
    void sheets(double t, double& value, double& slope) const
    {
        const glm::dvec3 q = p + t * d;
        const double rho = std::sqrt(q.x * q.x + q.z * q.z);
        const double y = (q.y - minor) * (q.y + minor);
        const double f = (rho - major) * (rho - major) + y, g = (rho + major) * (rho + major) + y;
        value = f * g;
        // d/dt |q|^2 / 2 = q.d; f' and g' combine to the polynomial's derivative without rho in a denominator.
        const double k = glm::dot(q, q) - minor * minor + major * major;
        slope = 4.0 * (glm::dot(q, d) * k - 2.0 * major * major * (q.x * d.x + q.z * d.z));
    }

    /// Bernstein coefficients of the quartic on [lo, hi] all positive, clear of rounding: no root there.
    bool misses(double lo, double hi) const
    {
        const double w = hi - lo, w2 = w * w, lo2 = lo * lo;
        // Taylor coefficients at lo, for s = (t - lo) / w.
        const double a0 = constant + lo * linear + lo2 * (square + lo2);
        const double a1 = w * (linear + lo * (2.0 * square + 4.0 * lo2));
        const double a2 = w2 * (square + 6.0 * lo2);
        const double a3 = w2 * w * (lo * 4.0);
        constexpr double kClear = 1e-13;  // of a polynomial whose terms are of order 1 after scaling (measured)
        return a0 > kClear && a0 + a1 / 4.0 > kClear && a0 + a1 / 2.0 + a2 / 6.0 > kClear &&
               a0 + 0.75 * a1 + 0.5 * a2 + 0.25 * a3 > kClear && a0 + a1 + a2 + a3 + w2 * w2 > kClear;
    }
};

/// Cube root of a positive number to about 1e-4: a third of the exponent, and one step of Halley's.
inline double rough_cube_root(double v)
{
    const double y = std::bit_cast<double>(std::bit_cast<std::uint64_t>(v) / 3 + 0x2a9f7893782da1ceull);
    const double cube = y * y * y;
    return y * (cube + 2.0 * v) / (2.0 * cube + v);
}

/// The largest real root of z^3 + a z^2 + b z + c for c <= 0, which has one that is not negative. Roughly by formula,
/// then by Newton on the cubic as given: its value has no cancellation near 0.
inline double largest_root(double a, double b, double c)
{
    const double third = a / 3.0;
    const double p = b / 3.0 - third * third, q = third * (third * third - 0.5 * b) + 0.5 * c;  // y^3 + 3 p y + 2 q
    const double inside = q * q + p * p * p;
    double y = 0.0;
    if (inside < 0.0) {
        // Three real roots: y = 2 m cos(angle / 3); in u = cos(angle / 2) that is smooth on all of [0, 1].
        const double m = std::sqrt(-p), x = -q / (m * m * m);
        const double u = std::sqrt(glm::max(0.5 + 0.5 * x, 0.0));
        // cos(2/3 acos u) to 4e-7: Chebyshev fit of degree 6 over [0, 1].
        constexpr double kCosine[] = {0.5000003853121096, 0.5773274274111112, -0.1107800277739088, 0.05142277070493927,
                                      -0.02636974636115907, 0.010521227858269878, -0.002122323277739942};
        double cosine = kCosine[6];
        for (int i = 5; i >= 0; --i) cosine = kCosine[i] + u * cosine;
        y = 2.0 * m * cosine;
    } else {
        const double w = std::abs(q) + std::sqrt(inside);
        if (w > 0.0) {
            const double root = rough_cube_root(w), size = root - p / root;
            y = q > 0.0 ? -size : size;
        }
    }
    double z = glm::max(y - third, 0.0);
    for (int i = 0; i < 12; ++i) {
        const double slope = b + z * (2.0 * a + 3.0 * z);
        if (!(slope > 0.0)) break;
        const double step = (c + z * (b + z * (a + z))) / slope;
        z = glm::max(z - step, 0.0);
        if (std::abs(step) <= 1e-9 * z) break;  // the next one would be below rounding
    }
    return z;
}

/// Crossings from the two quadratic factors of the quartic (t^2 + h t + u)(t^2 - h t + v), where h^2 is the largest
/// root of the resolvent (Descartes; numerically as in Orellana and De Michele, ACM Algorithm 1010, 2020), each
/// polished on the surface itself. -1 where that is not safe: near tangents, thin tori. Even and in order otherwise.
inline int torus_by_factors(const TorusRay& torus, double (&out)[4])
{
    // Smaller discriminants than this part of their terms may have the wrong sign (measured).
    constexpr double kTangent = 1e-6;
    const double b = torus.square, c = torus.linear, d = torus.constant;
    const double z = largest_root(2.0 * b, b * b - 4.0 * d, -c * c);
    const double h = std::sqrt(z), sum = b + z, quarter = 0.25 * z;
    // v - u: c / h, but from the product u v = d where h vanishes (rays along the axis or in the torus' plane).
    const double apart = z > 1e-2 ? std::abs(c) / h : std::sqrt(glm::max(sum * sum - 4.0 * d, 0.0));
    const double difference = c < 0.0 ? -apart : apart;
    const double u = 0.5 * (sum - difference), v = 0.5 * (sum + difference);
    int n = 0;
    for (const auto& [half, rest] : {std::pair(-0.5 * h, u), std::pair(0.5 * h, v)}) {
        const double discriminant = quarter - rest;
        if (!(std::abs(discriminant) > kTangent * (quarter + std::abs(rest)))) return -1;
        if (discriminant < 0.0) continue;
        const double reach = std::sqrt(discriminant);
        out[n++] = half - reach;
        out[n++] = half + reach;
    }
    if (n == 4) {
        if (out[2] < out[0]) std::swap(out[0], out[2]), std::swap(out[1], out[3]);
        if (out[2] < out[1]) std::swap(out[1], out[2]);
        if (out[3] < out[2]) std::swap(out[2], out[3]);
    }
    for (int i = 0; i < n; ++i) {
        double step = 1.0;
        for (int k = 0; k < 3 && !(std::abs(step) < 1e-9); ++k) {
            double value = 0.0, slope = 0.0;
            torus.sheets(out[i], value, slope);
            if (!((slope < 0.0) == (i % 2 == 0))) return -1;  // not an entry, or not an exit
            step = value / slope;
            out[i] -= step;
        }
        if (!(std::abs(step) < 1e-9) || (i > 0 && !(out[i] > out[i - 1]))) return -1;
    }
    return n;
}

}  // namespace csg::detail
