#pragma once

#include "csg/base/numbers.h"
#include "numbers/quartic_factors.h"

/// A torus along a ray, for one ray or several in vector lanes.
namespace csg::detail {

/// The torus along rays, about the foot of the perpendicular from the centre, scaled so that lengths are near 1.
template <class V = double>
struct TorusRay {
    V px, py, pz, dx, dy, dz;  ///< |d| = 1; dot(p, d) is 0 but for rounding, so the quartic has no cubic term
    double major, minor;
    V square = V(0.0), linear = V(0.0), constant = V(0.0);  ///< t^4 + square t^2 + linear t + constant

    void expand()
    {
        const double r2 = major * major;
        const V k = px * px + py * py + pz * pz - V(r2) - V(minor * minor);
        square = V(2.0) * (k + V(2.0 * r2) * dy * dy);
        linear = V(8.0 * r2) * py * dy;
        constant = k * k + V(4.0 * r2) * (py - V(minor)) * (py + V(minor));
    }
    /// Whether a crossing at t is one of a spindle's inner sheet: the sphere around the places where the sheets meet
    /// parts them.
    lanes::Truth<V> inner(V t) const
    {
        return px * px + py * py + pz * pz + t * t < V((minor - major) * (minor + major));
    }
    V derivative(V t) const { return linear + t * (V(2.0) * square + t * t * V(4.0)); }

    /// The quartic as the product of its two sheets, evaluated on the surface's own terms: coefficients cannot carry
    /// the accuracy of a thin torus.
    void sheets(V t, V& value, V& slope) const
    {
        const V x = px + t * dx, y = py + t * dy, z = pz + t * dz;
        const V across = x * x + z * z, rho = lanes::root_of(across);
        const V height = (y - V(minor)) * (y + V(minor));
        const V inner = rho - V(major), outer = rho + V(major);
        value = (inner * inner + height) * (outer * outer + height);
        // d/dt |q|^2 / 2 = q.d; the slopes of both combine to the polynomial's derivative without rho in a denominator.
        const V k = across + y * y + V(major * major - minor * minor);
        const V level = x * dx + z * dz;
        slope = V(4.0) * ((level + y * dy) * k - V(2.0 * major * major) * level);
    }

    /// Bernstein coefficients of the quartic on [lo, hi] all positive, clear of rounding: no root there.
    lanes::Truth<V> misses(V lo, V hi) const
    {
        const V w = hi - lo, w2 = w * w, lo2 = lo * lo;
        // Taylor coefficients at lo, for s = (t - lo) / w.
        const V a0 = constant + lo * linear + lo2 * (square + lo2);
        const V a1 = w * (linear + lo * (V(2.0) * square + V(4.0) * lo2));
        const V a2 = w2 * (square + V(6.0) * lo2);
        const V a3 = w2 * w * (lo * V(4.0));
        const V clear(1e-13);  // of a polynomial whose terms are of order 1 after scaling (measured)
        return (a0 > clear) & (a0 + a1 * V(0.25) > clear) & (a0 + a1 * V(0.5) + a2 * V(1.0 / 6.0) > clear) &
               (a0 + V(0.75) * a1 + V(0.5) * a2 + V(0.25) * a3 > clear) & (a0 + a1 + a2 + a3 + w2 * w2 > clear);
    }
};

template <class V>
inline QuarticFactors<V> torus_by_factors(const TorusRay<V>& torus)
{
    return quartic_by_factors<V>(torus);
}

}  // namespace csg::detail
