#pragma once

// Continues torus.h: the inline solver.
#include "numbers/safeguarded_newton.h"
#include "csg/solids/torus/torus.h"
#include "csg/solids/torus/torus_quartic.h"

namespace csg {

namespace detail {

/// Root of a function with opposite signs at lo and hi, until it moves by no more than `close`.
template <class Function>
double bracketed_root(const Function& f, double lo, double hi, bool negative_at_lo, double close)
{
    const auto at = [&f](double t) {
        ValueAndSlope here{};
        f(t, here.value, here.slope);
        return here;
    };
    return safeguarded_newton(at, lo, hi, negative_at_lo, 0.5 * (lo + hi), {close, 0.0}, 80);
}

/// Turns of the quartic inside (lo, hi), in order: they separate its roots. How far they are off costs only its square.
inline int torus_turns(const TorusRay<>& torus, double lo, double hi, double (&out)[3])
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
inline int torus_by_search(const TorusRay<>& torus, double lo, double hi, double (&out)[4])
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

/// Where rays may meet a torus: about the foot of the perpendicular, scaled.
template <class V>
struct TorusCourse {
    TorusRay<V> ray;
    V shift, rest, length;  ///< t = (shift + (rest + root / scale)) / length
    V lo, hi;               ///< roots lie between, scaled
    double scale;
    lanes::Truth<V> possible;  ///< false: it is clear of the torus

    V t(V root) const { return (shift + (rest + root * V(1.0 / scale))) / length; }

    /// Of crossings in order, the pairs that Torus::roots() tells of. four: the rays that have so many.
    void pair(lanes::Truth<V> four, V (&roots)[4]) const
    {
        if (!(ray.minor > ray.major)) return;
        const lanes::Truth<V> enters = ray.inner(roots[1]), leaves = ray.inner(roots[2]),
                              nested = four & enters & leaves;
        const V entry = roots[1], exit = roots[2];
        roots[1] = lanes::choose(nested, roots[3], roots[1]);
        roots[2] = lanes::choose(nested, entry, roots[2]);
        roots[3] = lanes::choose(nested, exit, roots[3]);
    }
};

/// Of |direction|^2: whether the rays come near the sphere around the torus. Most that miss end here, before any square
/// root. In the torus' own frame.
template <class V>
inline lanes::Truth<V> near_torus(const Torus& torus, const V (&o)[3], const V (&d)[3], V length2)
{
    const double outer = torus.major + torus.minor;
    const V foot = (o[0] * d[0] + o[1] * d[1] + o[2] * d[2]) / length2;
    const V x = o[0] - foot * d[0], y = o[1] - foot * d[1], z = o[2] - foot * d[2];
    const V limit = V(outer * outer * (1.0 + 1e-6)) + V(1e-12) * (o[0] * o[0] + o[1] * o[1] + o[2] * o[2]);
    return (length2 > V(0.0)) & (length2 < V(kInfinity)) & (x * x + y * y + z * z <= limit);
}

/// Sets rays up that are near_torus().
template <class V>
inline TorusCourse<V> torus_course(const Torus& torus, const V (&o)[3], const V (&direction)[3], V length2)
{
    const double outer = torus.major + torus.minor;
    TorusCourse<V> out;
    out.length = lanes::root_of(length2);
    const V dx = direction[0] / out.length, dy = direction[1] / out.length, dz = direction[2] / out.length;
    // Foot of the perpendicular, with one correction; what is left over is added to the roots, not to the shift.
    out.shift = V(0.0) - (o[0] * dx + o[1] * dy + o[2] * dz);
    V px = o[0] + out.shift * dx, py = o[1] + out.shift * dy, pz = o[2] + out.shift * dz;
    out.rest = V(0.0) - (px * dx + py * dy + pz * dz);
    px = px + out.rest * dx;
    py = py + out.rest * dy;
    pz = pz + out.rest * dz;
    const V distance = lanes::root_of(px * px + py * py + pz * pz);
    const V room = (V(outer) - distance) * (V(outer) + distance);
    const V half = lanes::root_of(room) * V(1.0 + 1e-12);  // a little more: the ends must lie outside
    V lo = V(0.0) - half, hi = half;
    const lanes::Truth<V> crosses = dy != V(0.0);
    const V inverse = V(1.0) / dy, reach = lanes::size_of(V(torus.minor) * inverse), middle = (V(0.0) - py) * inverse;
    const V low = middle - reach, high = middle + reach;
    lo = lanes::choose(crosses & (lo < low), low, lo);
    hi = lanes::choose(crosses & (high < hi), high, hi);
    out.possible = (room > V(0.0)) & (lo <= hi) & (crosses | !(lanes::size_of(py) > V(torus.minor)));

    out.scale = scale_to_one(outer);
    const V scale(out.scale);
    out.ray = {px * scale, py * scale, pz * scale, dx, dy, dz, torus.major * out.scale, torus.minor * out.scale};
    out.ray.expand();
    lo = lo * scale;
    hi = hi * scale;
    const V margin = V(1e-9) * (hi - lo) + V(1e-14);
    out.lo = lo - margin;
    out.hi = hi + margin;
    out.possible = out.possible & !out.ray.misses(out.lo, out.hi);
    return out;
}

/// A thinner tube asks for the search.
inline bool factors_serve(const Torus& torus)
{
    constexpr double kThin = 1e-3;
    return torus.major > 0.0 && torus.minor > kThin * torus.major;
}

}  // namespace detail

inline int Torus::roots(const Ray& ray, double (&out)[4]) const
{
    if (!(major > 0.0 && minor > 0.0)) return 0;
    const Ray local = local_ray(frame, ray);
    const double o[3] = {local.origin.x, local.origin.y, local.origin.z};
    const double d[3] = {local.direction.x, local.direction.y, local.direction.z};
    const double length2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    if (!detail::near_torus(*this, o, d, length2)) return 0;
    const detail::TorusCourse<double> course = detail::torus_course(*this, o, d, length2);
    if (!course.possible) return 0;
    int found = -1;
    if (detail::factors_serve(*this)) {
        const auto factors = detail::torus_by_factors(course.ray);
        if (factors.safe) {
            found = factors.four ? 4 : factors.two ? 2 : 0;
            for (int i = 0; i < found; ++i) out[i] = factors.roots[i];
        }
    }
    if (found < 0) found = detail::torus_by_search(course.ray, course.lo, course.hi, out);
    if (found == 4) course.pair(true, out);
    for (int i = 0; i < found; ++i) out[i] = course.t(out[i]);
    return found;
}

inline void Torus::intersect(const Ray& ray, SpanList& out) const
{
    double t[4];
    const int n = roots(ray, t);
    for (int i = 0; i + 1 < n; i += 2)
        if (i == 0 || t[i] > t[1]) out.push({{.t = t[i]}, {.t = t[i + 1]}});
}

inline int Torus::inner_sheet(const Ray& ray, double (&out)[2]) const
{
    double t[4];
    if (!spindle() || roots(ray, t) < 4 || t[2] > t[1]) return 0;
    out[0] = t[2];
    out[1] = t[3];
    return 2;
}

}  // namespace csg
