#pragma once

// Continues torus.h: the inline solver.
#include "csg/solids/torus.h"

namespace csg {

namespace detail {

/// The torus along one ray, about the foot of the perpendicular from the centre, scaled so that lengths are near 1.
struct TorusRay {
    glm::dvec3 p, d;              ///< |d| = 1
    double major, minor;
    double c[5];                  ///< monic quartic, c[4] = 1

    void expand()
    {
        const double k1 = glm::dot(p, p) - major * major - minor * minor, k2 = glm::dot(p, d);
        const double r2 = major * major;
        c[4] = 1.0;
        c[3] = 4.0 * k2;
        c[2] = 2.0 * (k1 + 2.0 * k2 * k2 + 2.0 * r2 * d.y * d.y);
        c[1] = 4.0 * (k1 * k2 + 2.0 * r2 * p.y * d.y);
        c[0] = k1 * k1 + 4.0 * r2 * (p.y - minor) * (p.y + minor);
    }
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
};

/// Bernstein coefficients on [lo, hi] all positive, clear of rounding: no root there.
inline bool torus_misses(const double (&c)[5], double lo, double hi)
{
    const double w = hi - lo;
    // Taylor coefficients at lo, for s = (t - lo) / w.
    const double a0 = c[0] + lo * (c[1] + lo * (c[2] + lo * (c[3] + lo)));
    const double a1 = w * (c[1] + lo * (2.0 * c[2] + lo * (3.0 * c[3] + lo * 4.0)));
    const double a2 = w * w * (c[2] + lo * (3.0 * c[3] + lo * 6.0));
    const double a3 = w * w * w * (c[3] + lo * 4.0);
    const double a4 = w * w * w * w;
    constexpr double kClear = 1e-13;  // of a polynomial whose terms are of order 1 after scaling (measured)
    return a0 > kClear && a0 + a1 / 4.0 > kClear && a0 + a1 / 2.0 + a2 / 6.0 > kClear &&
           a0 + 0.75 * a1 + 0.5 * a2 + 0.25 * a3 > kClear && a0 + a1 + a2 + a3 + a4 > kClear;
}

/// Root of a function with opposite signs at lo and hi: Newton, kept inside the bracket by bisection.
template <class Function>
double bracketed_root(const Function& f, double lo, double hi, bool negative_at_lo)
{
    double t = 0.5 * (lo + hi);
    for (int i = 0; i < 80; ++i) {
        double value = 0.0, slope = 0.0;
        f(t, value, slope);
        if (value == 0.0) return t;
        ((value < 0.0) == negative_at_lo ? lo : hi) = t;
        double next = t - value / slope;
        if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
        if (next == t || next == lo || next == hi) return next;
        const double moved = std::abs(next - t);
        t = next;
        if (moved <= 1e-16 * std::abs(t)) return t;
    }
    return t;
}

/// Real roots of the derivative of a monic quartic inside (lo, hi), in order: they separate the quartic's roots.
inline int quartic_turns(const double (&c)[5], double lo, double hi, double (&out)[3])
{
    const auto slope = [&](double t, double& value, double& derivative) {
        value = c[1] + t * (2.0 * c[2] + t * (3.0 * c[3] + t * 4.0));
        derivative = 2.0 * c[2] + t * (6.0 * c[3] + t * 12.0);
    };
    double ends[4] = {lo, lo, lo, hi};
    int n = 1;
    const double b = 3.0 * c[3], discriminant = b * b - 24.0 * c[2];  // of 12 t^2 + 2 b t + 2 c2
    if (discriminant > 0.0) {
        const double q = -(b + std::copysign(std::sqrt(discriminant), b));
        const double r0 = q / 12.0, r1 = q != 0.0 ? 2.0 * c[2] / q : 0.0;
        const double near = glm::min(r0, r1), far = glm::max(r0, r1);
        if (near > lo && near < hi) ends[n++] = near;
        if (far > lo && far < hi) ends[n++] = far;
    }
    ends[n] = hi;
    int found = 0;
    double before = 0.0, unused = 0.0;
    slope(ends[0], before, unused);
    for (int i = 0; i < n; ++i) {
        double after = 0.0;
        slope(ends[i + 1], after, unused);
        if ((before < 0.0) != (after < 0.0)) out[found++] = bracketed_root(slope, ends[i], ends[i + 1], before < 0.0);
        before = after;
    }
    return found;
}

}  // namespace detail

inline int Torus::roots(const Ray& ray, double (&out)[4]) const
{
    if (!(major > 0.0 && minor > 0.0)) return 0;
    const Ray given = local_ray(frame, ray);
    const double length = std::sqrt(glm::dot(given.direction, given.direction));
    if (!(length > 0.0 && length < kInfinity)) return 0;
    const glm::dvec3 d = given.direction / length;
    // Foot of the perpendicular, with one correction; what is left over (e) is added to the roots, not to the shift.
    const double shift = -glm::dot(given.origin, d);
    glm::dvec3 p = given.origin + shift * d;
    const double e = -glm::dot(p, d);
    p += e * d;
    const double outer = major + minor;
    const double room = (outer - std::sqrt(glm::dot(p, p))) * (outer + std::sqrt(glm::dot(p, p)));
    if (!(room > 0.0)) return 0;
    Interval range;
    if (!slab(p.y, d.y, -minor, minor, range)) return 0;
    const double half = std::sqrt(room) * (1.0 + 1e-12);  // a little more: the ends must lie outside
    double lo = glm::max(range.entry, -half), hi = glm::min(range.exit, half);
    if (!(lo <= hi)) return 0;

    const double scale = std::ldexp(1.0, -std::ilogb(outer) - 1);  // exact: outer in [1/2, 1)
    detail::TorusRay torus{p * scale, d, major * scale, minor * scale, {}};
    torus.expand();
    lo *= scale;
    hi *= scale;
    const double margin = 1e-9 * (hi - lo) + 1e-14;
    lo -= margin;
    hi += margin;
    if (detail::torus_misses(torus.c, lo, hi)) return 0;

    double turns[3];
    double ends[5] = {lo, hi, hi, hi, hi};
    const int n = detail::quartic_turns(torus.c, lo, hi, turns);
    for (int i = 0; i < n; ++i) ends[i + 1] = turns[i];
    ends[n + 1] = hi;
    const auto surface = [&](double t, double& value, double& slope) { torus.sheets(t, value, slope); };
    int found = 0;
    double before = 0.0, unused = 0.0;
    torus.sheets(lo, before, unused);
    for (int i = 0; i <= n && found < 4; ++i) {
        double after = 0.0;
        torus.sheets(ends[i + 1], after, unused);
        if ((before < 0.0) != (after < 0.0)) {
            const double root = detail::bracketed_root(surface, ends[i], ends[i + 1], before < 0.0);
            out[found++] = (shift + (e + root / scale)) / length;
        }
        before = after;
    }
    return found & ~1;  // an odd count would swap inside and outside for the rest of the ray
}

inline bool Torus::on_inner_sheet(const glm::dvec3& l) const
{
    // On the inner sheet (rho + major)^2 + y^2 = minor^2; on the outer one (rho - major)^2 + y^2 = minor^2.
    const double rho = std::sqrt(l.x * l.x + l.z * l.z), y = (l.y - minor) * (l.y + minor);
    return std::abs((rho + major) * (rho + major) + y) < std::abs((rho - major) * (rho - major) + y);
}

inline void Torus::intersect(const Ray& ray, SpanList& out) const
{
    double t[4];
    const int n = roots(ray, t);
    if (!spindle()) {
        for (int i = 0; i + 1 < n; i += 2) out.push({{.t = t[i]}, {.t = t[i + 1]}});
        return;
    }
    if (n == 0) return;
    double outer[4];
    int kept = 0;
    for (int i = 0; i < n; ++i)
        if (!on_inner_sheet(frame.inverse_point(ray.at(t[i])))) outer[kept++] = t[i];
    for (int i = 0; i + 1 < kept; i += 2) out.push({{.t = outer[i]}, {.t = outer[i + 1]}});
}

inline int Torus::inner_sheet(const Ray& ray, double (&out)[4]) const
{
    double t[4];
    const int n = spindle() ? roots(ray, t) : 0;
    int kept = 0;
    for (int i = 0; i < n; ++i)
        if (on_inner_sheet(frame.inverse_point(ray.at(t[i])))) out[kept++] = t[i];
    return kept;
}

}  // namespace csg
