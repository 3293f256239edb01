#pragma once

#include "numbers/quartic_factors.h"

/// A torus along a ray, for one ray or several in vector lanes.
namespace csg::detail {

/// The torus along rays, about the foot of the perpendicular from the centre, scaled so that lengths are near 1.
template <class Ops = OneRay>
struct TorusRay {
    using T = typename Ops::Number;

    T px, py, pz, dx, dy, dz;  ///< |d| = 1; dot(p, d) is 0 but for rounding, so the quartic has no cubic term
    double major, minor;
    T square = T(0.0), linear = T(0.0), constant = T(0.0);  ///< t^4 + square t^2 + linear t + constant

    void expand()
    {
        const double r2 = major * major;
        const T k = px * px + py * py + pz * pz - T(r2) - T(minor * minor);
        square = T(2.0) * (k + T(2.0 * r2) * dy * dy);
        linear = T(8.0 * r2) * py * dy;
        constant = k * k + T(4.0 * r2) * (py - T(minor)) * (py + T(minor));
    }
    T derivative(T t) const { return linear + t * (T(2.0) * square + t * t * T(4.0)); }

    /// The quartic as the product of its two sheets, evaluated on the surface's own terms: coefficients cannot carry
    /// the accuracy of a thin torus.
    void sheets(T t, T& value, T& slope) const
    {
        const T x = px + t * dx, y = py + t * dy, z = pz + t * dz;
        const T across = x * x + z * z, rho = Ops::sqrt(across);
        const T height = (y - T(minor)) * (y + T(minor));
        const T inner = rho - T(major), outer = rho + T(major);
        value = (inner * inner + height) * (outer * outer + height);
        // d/dt |q|^2 / 2 = q.d; the slopes of both combine to the polynomial's derivative without rho in a denominator.
        const T k = across + y * y + T(major * major - minor * minor);
        const T level = x * dx + z * dz;
        slope = T(4.0) * ((level + y * dy) * k - T(2.0 * major * major) * level);
    }

    /// Bernstein coefficients of the quartic on [lo, hi] all positive, clear of rounding: no root there.
    typename Ops::Bool misses(T lo, T hi) const
    {
        const T w = hi - lo, w2 = w * w, lo2 = lo * lo;
        // Taylor coefficients at lo, for s = (t - lo) / w.
        const T a0 = constant + lo * linear + lo2 * (square + lo2);
        const T a1 = w * (linear + lo * (T(2.0) * square + T(4.0) * lo2));
        const T a2 = w2 * (square + T(6.0) * lo2);
        const T a3 = w2 * w * (lo * T(4.0));
        const T clear(1e-13);  // of a polynomial whose terms are of order 1 after scaling (measured)
        return Ops::both(
            Ops::both(Ops::both(a0 > clear, a0 + a1 * T(0.25) > clear), a0 + a1 * T(0.5) + a2 * T(1.0 / 6.0) > clear),
            Ops::both(a0 + T(0.75) * a1 + T(0.5) * a2 + T(0.25) * a3 > clear, a0 + a1 + a2 + a3 + w2 * w2 > clear));
    }
};

template <class Ops>
inline QuarticFactors<Ops> torus_by_factors(const TorusRay<Ops>& torus)
{
    return quartic_by_factors<Ops>(torus);
}

}  // namespace csg::detail
