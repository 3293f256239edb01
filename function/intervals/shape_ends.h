#pragma once

#include "function/intervals/ends.h"
#include "numbers/functions/functions.h"

/// Ranges of the internal functions that are more than polynomials: the formulas of internal_shapes.cpp over intervals
/// in lanes, written so that a number stands as seldom as may be. What has no room of its own is far below that of
/// angles.
namespace function {

inline Ends smaller(const Ends& a, const Ends& b) { return {xsimd::min(a.low, b.low), xsimd::min(a.high, b.high)}; }
inline Ends negative(const Ends& a) { return {-a.high, -a.low}; }
inline Ends cosine(const Ends& a) { return sine(a, std::numbers::pi / 2); }
inline Ends length(const Ends& x, const Ends& y) { return sqrt(squared(x) + squared(y)); }
inline Ends length(const Ends& x, const Ends& y, const Ends& z) { return sqrt(squared(x) + squared(y) + squared(z)); }

/// x, and `off_axis` where x and z may both be 0: there the functions take that instead.
inline Ends beside_axis(const Ends& x, const Ends& z, double off_axis)
{
    const Batch zero(0.0);
    const auto on_axis = (x.low <= zero) & (x.high >= zero) & (z.low <= zero) & (z.high >= zero);
    return {x.low, xsimd::select(on_axis, xsimd::max(x.high, Batch(off_axis)), x.high)};
}

/// Distance of (a, b) from the centre of a profile. The same for -a and -b.
inline Ends profile(const Ends& a, const Ends& b, double kind)
{
    if (kind == 1.0) return length(a, b);
    if (kind == 0.0) return larger(absolute(a), absolute(b));
    return power(power(absolute(a), 2.0 / kind) + power(absolute(b), 2.0 / kind), kind * 0.5);
}

inline Ends blob_range(const Ends* a)
{
    const Ends aside = squared(a[1]) + squared(a[2]);
    const auto part = [&](const Ends& x, const Ends& strength, const Ends& inverse_radius) {
        const Ends d = 1.0 - smaller(1.0, squared(inverse_radius) * (squared(x) + aside));
        return strength * squared(d);
    };
    return negative(part(a[0] + 0.5 * a[3], a[4], a[5])) - part(a[0] - 0.5 * a[3], a[6], a[7]);
}

inline Ends blob2_range(const Ends* a)
{
    const Ends aside = squared(a[1]) + squared(a[2]);
    const auto bell = [&](const Ends& x) { return exponential(negative(a[4] * (squared(x) + aside))); };
    return a[6] - a[5] * (bell(a[0]) + bell(a[0] - a[3]));
}

inline Ends comma_range(const Ends* a)
{
    const Ends x = beside_axis(a[0], a[2], 1e-4), y2 = squared(a[1]), p = a[3];
    const Ends r = length(x + 0.25 * p, a[2]);
    const Ends lower = smaller(a[2], 0.5 * p * cosine(0.5 * arc_tangent(a[2], x)) - sqrt(squared(r - 0.75 * p) + y2));
    const Ends head = 0.5 * p - sqrt(squared(x - 0.5 * p) + y2 + squared(a[2]));
    return negative(larger(lower, head));
}

/// The bells of ellipsoids and spikes along z, y and x.
struct Bells {
    Ends z, y, x;
    explicit Bells(const Ends* a)
    {
        const Ends k = a[3], w = a[4], x2 = squared(a[0]), y2 = squared(a[1]), z2 = squared(a[2]);
        const auto bell = [&](const Ends& along, const Ends& one, const Ends& other) {
            return exponential(negative(w * (k * (one + other) + along)));
        };
        z = bell(z2, x2, y2), y = bell(y2, x2, z2), x = bell(x2, y2, z2);
    }
};

inline Ends ellipsoids_range(std::uint32_t n, const Ends* a)
{
    const Bells e(a);
    const Ends all = n == 10   ? larger(larger(e.z, e.y), e.x)
                     : n == 32 ? smaller(smaller(e.z, e.y), e.x)
                               : e.z + e.y + e.x;
    return a[6] - a[5] * all;
}

inline Ends spikes_range(const Ends* a)
{
    const Bells e(a);
    const Ends s = squared(a[0]) + squared(a[1]) + squared(a[2]);
    return a[5] * (e.z + e.y + e.x - a[7] * exponential(negative(a[6] * s)));
}

/// False, with nothing done, for parameters that are no constants.
inline bool helix1_range(const Ends* a, Ends& out)
{
    const Ends* p = a + 3;
    for (const int k : {0, 1, 4, 5, 6})
        if (!is_constant(p[k])) return false;
    using std::numbers::pi;
    const double kind = p[5].low.get(0), pitch = p[4].low.get(0) * p[0].low.get(0) * p[1].low.get(0);
    if (pitch == 0.0) return false;
    const Ends rho = length(a[0], a[2]), theta = p[0] * (arc_tangent(a[2], a[0]) + p[1] * a[1]);
    const Ends d = rho - p[3];
    Ends across;
    if (kind == 1.0 || p[6].low.get(0) == 0.0) {
        across = profile(d, from_odd_multiples(theta, pi) * (1.0 / std::abs(pitch)), kind);
    } else {
        // The sign counts too: on both sides of a seam it may be either.
        const Batch from = theta.low * Batch(0.5 / pi), to = theta.high * Batch(0.5 / pi), start = xsimd::floor(from),
                    room(1e-9);
        const auto one_turn = (to + room < start + Batch(1.0)) & (from - room >= start);
        const Ends turned{xsimd::select(one_turn, from - start - Batch(0.5) - room, Batch(-0.5)),
                          xsimd::select(one_turn, to - start - Batch(0.5) + room, Batch(0.5))};
        const double angle = p[6].low.get(0) * pi / 180.0, c = numbers::cos(angle), s = numbers::sin(angle);
        const Ends b = turned * (2.0 * pi / pitch);
        across = profile(d * c - b * s, d * s + b * c, kind);
    }
    out = smaller(p[3] + rho, across) - p[2];
    return true;
}

inline bool helix2_range(const Ends* a, Ends& out)
{
    const Ends* p = a + 3;
    if (!is_constant(p[5])) return false;
    const Ends c = cosine(p[1] * a[1]), s = sine(p[1] * a[1], 0.0);
    // (x - r c) c + (z - r s) s and (z - r s) c - (x - r c) s, in which r stands once; the library's rounding is
    // another.
    const Batch room = (xsimd::max(xsimd::abs(a[0].low), xsimd::abs(a[0].high)) +
                        xsimd::max(xsimd::abs(a[2].low), xsimd::abs(a[2].high)) +
                        xsimd::max(xsimd::abs(p[3].low), xsimd::abs(p[3].high))) *
                       Batch(1e-14);
    const auto roomy = [&](const Ends& e) { return Ends{e.low - room, e.high + room}; };
    out = profile(roomy(a[0] * c + a[2] * s - p[3]), roomy(a[2] * c - a[0] * s), p[5].low.get(0)) - p[2];
    return true;
}

inline bool mesh1_range(const Ends* a, Ends& out)
{
    const Ends* p = a + 3;
    if (!is_constant(p[0]) || !is_constant(p[1])) return false;
    const double first = p[0].low.get(0), second = p[1].low.get(0);
    if (!(first > 0.0 && second > 0.0)) return false;
    const auto thread = [&](const Ends& up, const Ends& along, double distance) {
        return length(p[4] * up, from_odd_multiples(along, distance) * p[2]);
    };
    const Ends over = p[3] * cosine(a[2] * (std::numbers::pi / second)),
               under = p[3] * cosine(a[0] * (std::numbers::pi / first));
    out = smaller(smaller(thread(a[1] - over, a[0], first), thread(a[1] + over, a[0] - first, first)),
                  smaller(thread(a[1] + under, a[2], second), thread(a[1] - under, a[2] - second, second)));
    return true;
}

/// a + y (b + y (c + ...)); numbers as powers of y in sums have the same ends where y has one sign.
inline Ends in_powers(const Ends* coefficients, const Ends& y)
{
    const Ends y2 = squared(y);
    return coefficients[0] + coefficients[1] * y + coefficients[2] * y2 + coefficients[3] * (y2 * y) +
           coefficients[4] * squared(y2);
}

inline bool polytubes_range(const Ends* a, Ends& out)
{
    if (!is_constant(a[3])) return false;
    constexpr double kMost = 64.0;
    const double tubes = a[3].low.get(0), number = std::trunc(tubes);
    if (!(number <= kMost)) return false;
    const Ends r = in_powers(a + 4, a[1]);
    out = 10000.0;
    for (double i = 0.0; i < number; i += 1.0) {
        const double angle = 2.0 * std::numbers::pi * i / tubes;
        out = smaller(out, length(a[0] - r * numbers::sin(angle), a[2] - r * numbers::cos(angle)));
    }
    return true;
}

/// With r half the function's, r^2 (3 cos^2 - 1) = 2 y^2 - rho^2, in which each stands once; the library's rounding is
/// another.
inline Ends quantum_range(const Ends* a)
{
    const Ends x = beside_axis(a[0], a[2], 1e-6), rho2 = squared(x) + squared(a[2]), y2 = squared(a[1]);
    const Ends lobes = 2.0 * y2 - rho2;
    const Batch room = (y2.high + rho2.high) * Batch(1e-13);
    const Ends t = 4.0 * Ends(lobes.low - room, lobes.high + room) * exponential(-0.66666666 * sqrt(rho2 + y2));
    return -0.1 * (squared(t) - 12.0);
}

inline bool superellipsoid_range(const Ends* a, Ends& out)
{
    if (!is_constant(a[3]) || !is_constant(a[4])) return false;
    const double east = a[3].low.get(0), north = a[4].low.get(0);
    if (!(east > 0.0 && north > 0.0)) return false;
    const Ends round = power(power(absolute(a[0]), 2.0 / east) + power(absolute(a[1]), 2.0 / east), east / north);
    out = 1.0 - power(round + power(absolute(a[2]), 2.0 / north), north * 0.5);
    return true;
}

/// False, with nothing done, for other functions and where a parameter would have to be a constant.
inline bool shape_range(std::uint32_t n, const Ends* a, Ends& out)
{
    switch (n) {
    case 6: out = blob_range(a); return true;
    case 7: out = blob2_range(a); return true;
    case 9: out = comma_range(a); return true;
    case 10:
    case 19:
    case 32: out = ellipsoids_range(n, a); return true;
    case 25: return helix1_range(a, out);
    case 26: return helix2_range(a, out);
    case 40: return mesh1_range(a, out);
    case 51: out = length(a[0], a[2]) - larger(-5.0, in_powers(a + 3, a[1])); return true;
    case 52: return polytubes_range(a, out);
    case 53: out = quantum_range(a); return true;
    case 62: out = spikes_range(a); return true;
    case 63:
        out = a[1] - a[3] * cosine(a[4] * a[0]) * cosine(a[5] * a[2]) *
                         exponential(negative(a[6] * (squared(a[0]) + squared(a[2]))));
        return true;
    case 68: return superellipsoid_range(a, out);
    default: return false;
    }
}

}  // namespace function
