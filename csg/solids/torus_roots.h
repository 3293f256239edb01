#pragma once

// Continues torus.h: the inline solver.
#include "csg/solids/torus.h"
#include "csg/solids/torus_quartic.h"

namespace csg {

namespace detail {

/// Root of a function with opposite signs at lo and hi: Newton, kept inside the bracket by bisection, until it moves by
/// no more than `close`.
template <class Function>
double bracketed_root(const Function& f, double lo, double hi, bool negative_at_lo, double close)
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
        if (moved <= close) return t;
    }
    return t;
}

/// Turns of the quartic inside (lo, hi), in order: they separate its roots. How far they are off costs only its square.
inline int torus_turns(const TorusRay& torus, double lo, double hi, double (&out)[3])
{
    const double close = 1e-10 * (hi - lo);
    const auto slope = [&](double t, double& value, double& derivative) {
        value = torus.derivative(t);
        derivative = 2.0 * torus.square + 12.0 * t * t;
    };
    double ends[4] = {lo, hi, hi, hi};
    int n = 1;
    if (torus.square < 0.0) {
        const double bend = std::sqrt(torus.square / -6.0);
        if (-bend > lo && -bend < hi) ends[n++] = -bend;
        if (bend > lo && bend < hi) ends[n++] = bend;
    }
    ends[n] = hi;
    int found = 0;
    double before = torus.derivative(lo);
    for (int i = 0; i < n; ++i) {
        const double after = torus.derivative(ends[i + 1]);
        if ((before < 0.0) != (after < 0.0))
            out[found++] = bracketed_root(slope, ends[i], ends[i + 1], before < 0.0, close);
        before = after;
    }
    return found;
}

/// Crossings in (lo, hi) by sign changes between the turns: sure, but slower than by factors.
inline int torus_by_search(const TorusRay& torus, double lo, double hi, double (&out)[4])
{
    double turns[3];
    double ends[5] = {lo, hi, hi, hi, hi};
    const int n = torus_turns(torus, lo, hi, turns);
    for (int i = 0; i < n; ++i) ends[i + 1] = turns[i];
    ends[n + 1] = hi;
    const auto surface = [&](double t, double& value, double& slope) { torus.sheets(t, value, slope); };
    int found = 0;
    double before = 0.0, unused = 0.0;
    torus.sheets(lo, before, unused);
    for (int i = 0; i <= n && found < 4; ++i) {
        double after = 0.0;
        torus.sheets(ends[i + 1], after, unused);
        if ((before < 0.0) != (after < 0.0))
            out[found++] = bracketed_root(surface, ends[i], ends[i + 1], before < 0.0, 1e-17);
        before = after;
    }
    return found & ~1;  // an odd count would swap inside and outside for the rest of the ray
}

/// The power of two that brings a length into [1/2, 1): scaling by it is exact.
inline double scale_to_one(double length)
{
    const std::uint64_t exponent = std::bit_cast<std::uint64_t>(length) >> 52;
    if (exponent < 64 || exponent > 1980) return std::ldexp(1.0, -std::ilogb(length) - 1);
    return std::bit_cast<double>((2045 - exponent) << 52);
}

}  // namespace detail

inline int Torus::roots(const Ray& ray, double (&out)[4]) const
{
    if (!(major > 0.0 && minor > 0.0)) return 0;
    const Ray given = local_ray(frame, ray);
    const double length2 = glm::dot(given.direction, given.direction);
    if (!(length2 > 0.0 && length2 < kInfinity)) return 0;
    // Clear of the sphere around it: most rays that miss end here, before any square root.
    const double outer = major + minor;
    const glm::dvec3 rough = given.origin - (glm::dot(given.origin, given.direction) / length2) * given.direction;
    if (glm::dot(rough, rough) > outer * outer * (1.0 + 1e-6) + 1e-12 * glm::dot(given.origin, given.origin)) return 0;

    const double length = std::sqrt(length2);
    const glm::dvec3 d = given.direction / length;
    // Foot of the perpendicular, with one correction; what is left over (e) is added to the roots, not to the shift.
    const double shift = -glm::dot(given.origin, d);
    glm::dvec3 p = given.origin + shift * d;
    const double e = -glm::dot(p, d);
    p += e * d;
    const double distance = std::sqrt(glm::dot(p, p));
    const double room = (outer - distance) * (outer + distance);
    if (!(room > 0.0)) return 0;
    const double half = std::sqrt(room) * (1.0 + 1e-12);  // a little more: the ends must lie outside
    double lo = -half, hi = half;
    if (d.y != 0.0) {
        const double inverse = 1.0 / d.y, reach = std::abs(minor * inverse), middle = -p.y * inverse;
        lo = glm::max(lo, middle - reach);
        hi = glm::min(hi, middle + reach);
    } else if (std::abs(p.y) > minor) {
        return 0;
    }
    if (!(lo <= hi)) return 0;

    const double scale = detail::scale_to_one(outer);
    detail::TorusRay torus{p * scale, d, major * scale, minor * scale};
    torus.expand();
    lo *= scale;
    hi *= scale;
    const double margin = 1e-9 * (hi - lo) + 1e-14;
    lo -= margin;
    hi += margin;
    if (torus.misses(lo, hi)) return 0;

    constexpr double kThin = 1e-3;  // a thinner tube, or a spindle's inner sheet, asks for the search
    int found = -1;
    if (minor > kThin * major && !spindle()) found = detail::torus_by_factors(torus, out);
    if (found < 0) found = detail::torus_by_search(torus, lo, hi, out);
    for (int i = 0; i < found; ++i) out[i] = (shift + (e + out[i] / scale)) / length;
    return found;
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
