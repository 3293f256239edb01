#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

/// Quartics solved by factors. Everything is written for a kind of number: one ray, or several in vector lanes, with
/// the same operations in the same order and so the same bits.
namespace csg::detail {

/// One ray.
struct OneRay {
    using Number = double;
    using Bool = bool;
    static double pick(bool which, double yes, double no) { return which ? yes : no; }
    static bool both(bool a, bool b) { return a && b; }
    static bool either(bool a, bool b) { return a || b; }
    static bool any(bool b) { return b; }
    static double sqrt(double v) { return std::sqrt(v); }
    static double abs(double v) { return std::abs(v); }
    /// A positive number to about a tenth of its cube root: a third of the exponent. The series in quarters is for
    /// lanes, which cannot divide integers.
    static double cube_root_seed(double v)
    {
        std::uint64_t third = std::bit_cast<std::uint64_t>(v) >> 2;
        third += third >> 2;
        third += third >> 4;
        third += third >> 8;
        third += third >> 16;
        return std::bit_cast<double>(third + 0x2a9f7893782da1ceull);
    }
};

/// y of y^3 + 3 p y + 2 q with three real roots: y = 2 m cos(angle / 3), to 4e-7.
template <class Ops>
inline typename Ops::Number largest_of_three(typename Ops::Number p, typename Ops::Number q)
{
    using T = typename Ops::Number;
    const T m = Ops::sqrt(T(0.0) - p), x = (T(0.0) - q) / (m * m * m);
    // In u = cos(angle / 2) that is smooth on all of [0, 1]. cos(2/3 acos u): Chebyshev fit of degree 6.
    const T square = T(0.5) + T(0.5) * x, u = Ops::sqrt(Ops::pick(square > T(0.0), square, T(0.0)));
    constexpr double kCosine[] = {0.5000003853121096,   0.5773274274111112,   -0.1107800277739088,  0.05142277070493927,
                                  -0.02636974636115907, 0.010521227858269878, -0.002122323277739942};
    T cosine(kCosine[6]);
    for (int i = 5; i >= 0; --i) cosine = T(kCosine[i]) + u * cosine;
    return T(2.0) * m * cosine;
}

/// The same with one real root, to about 1e-4: Cardano's formula with one step of Halley's for the cube root.
template <class Ops>
inline typename Ops::Number only_root(typename Ops::Number p, typename Ops::Number q, typename Ops::Number inside)
{
    using T = typename Ops::Number;
    const T w = Ops::abs(q) + Ops::sqrt(inside);
    const T seed = Ops::cube_root_seed(w), cube = seed * seed * seed;
    const T root = seed * (cube + T(2.0) * w) / (T(2.0) * cube + w), size = root - p / root;
    return Ops::pick(w > T(0.0), Ops::pick(q > T(0.0), T(0.0) - size, size), T(0.0));
}

/// The largest real root of z^3 + a z^2 + b z + c for c <= 0, which has one that is not negative. Roughly by formula,
/// then by Newton on the cubic as given: its value has no cancellation near 0.
template <class Ops>
inline typename Ops::Number largest_root(typename Ops::Number a, typename Ops::Number b, typename Ops::Number c)
{
    using T = typename Ops::Number;
    const T zero(0.0);
    const T third = a * T(1.0 / 3.0);
    const T p = b * T(1.0 / 3.0) - third * third,
            q = third * (third * third - T(0.5) * b) + T(0.5) * c;  // y^3 + 3 p y + 2 q
    const T inside = q * q + p * p * p;
    const typename Ops::Bool three = inside < zero, one = !three;
    T y = zero;
    if (Ops::any(three)) y = largest_of_three<Ops>(p, q);
    if (Ops::any(one)) y = Ops::pick(one, only_root<Ops>(p, q, inside), y);
    T z = y - third;
    z = Ops::pick(z > zero, z, zero);
    auto active = z == z;
    for (int i = 0; i < 12; ++i) {
        const T slope = b + z * (T(2.0) * a + T(3.0) * z);
        active = Ops::both(active, slope > zero);
        if (!Ops::any(active)) break;
        const T step = (c + z * (b + z * (a + z))) / slope, next = z - step;
        z = Ops::pick(active, Ops::pick(next > zero, next, zero), z);
        active = Ops::both(active, !(Ops::abs(step) <= T(1e-9) * z));  // the next one would be below rounding
    }
    return z;
}

/// What factors give: `safe` false asks for the search instead. Crossings in order, an even number: none, roots[0] and
/// [1] where `two`, all where `four`.
template <class Ops>
struct QuarticFactors {
    typename Ops::Number roots[4];
    typename Ops::Bool safe, two, four;
};

/// Newton on the surface itself; an even root is an entry, an odd one an exit. Clears `safe` where it is not.
template <class Ops, class Curve>
inline void polish(const Curve& curve, bool entry, typename Ops::Bool active, typename Ops::Number& root,
                   typename Ops::Bool& safe)
{
    using T = typename Ops::Number;
    for (int k = 0; k < 3 && Ops::any(active); ++k) {
        T value(0.0), slope(0.0);
        curve.sheets(root, value, slope);
        const typename Ops::Bool falls = slope < T(0.0);
        safe = Ops::both(safe, Ops::either(!active, entry ? falls : !falls));
        const T step = value / slope;
        root = Ops::pick(active, root - step, root);
        active = Ops::both(active, !(Ops::abs(step) < T(1e-9)));
    }
    safe = Ops::both(safe, !active);
}

/// Crossings from the two quadratic factors of the quartic (t^2 + h t + u)(t^2 - h t + v), where h^2 is the largest
/// root of the resolvent (Descartes; numerically as in Orellana and De Michele, ACM Algorithm 1010, 2020), each
/// polished. Not safe near tangents.
///
/// `curve`: square, linear and constant of t^4 + square t^2 + linear t + constant, whose roots are of order 1, and
/// sheets(t, value, slope) to polish with.
template <class Ops, class Curve>
inline QuarticFactors<Ops> quartic_by_factors(const Curve& curve)
{
    using T = typename Ops::Number;
    // Smaller discriminants than this part of their terms may have the wrong sign (measured).
    const T tangent(1e-6), zero(0.0);
    const T b = curve.square, c = curve.linear, d = curve.constant;
    const T z = largest_root<Ops>(T(2.0) * b, b * b - T(4.0) * d, zero - c * c);
    const T h = Ops::sqrt(z), sum = b + z, quarter = T(0.25) * z;
    // v - u: c / h, but from the product u v = d where h vanishes (rays along the axis or in the torus' plane).
    const T product = sum * sum - T(4.0) * d;
    const T apart = Ops::pick(z > T(1e-2), Ops::abs(c) / h, Ops::sqrt(Ops::pick(product > zero, product, zero)));
    const T difference = Ops::pick(c < zero, zero - apart, apart);
    const T u = T(0.5) * (sum - difference), v = T(0.5) * (sum + difference);
    const T below_u = quarter - u, below_v = quarter - v, half = T(0.5) * h;
    QuarticFactors<Ops> out;
    out.safe = Ops::both(Ops::abs(below_u) > tangent * (quarter + Ops::abs(u)),
                         Ops::abs(below_v) > tangent * (quarter + Ops::abs(v)));
    const typename Ops::Bool has_u = below_u > zero, has_v = below_v > zero;
    out.two = Ops::both(out.safe, Ops::either(has_u, has_v));
    out.four = Ops::both(out.two, Ops::both(has_u, has_v));
    if (!Ops::any(out.two)) return out;
    const T reach_u = Ops::sqrt(below_u), reach_v = Ops::sqrt(below_v);
    T a = zero - half - reach_u, a_out = zero - half + reach_u, e = half - reach_v, e_out = half + reach_v;
    // The pair that is there comes first, or the one that begins first.
    const typename Ops::Bool swap = Ops::either(!has_u, Ops::both(out.four, e < a));
    T& r0 = out.roots[0] = Ops::pick(swap, e, a);
    T& r1 = out.roots[1] = Ops::pick(swap, e_out, a_out);
    T& r2 = out.roots[2] = Ops::pick(swap, a, e);
    T& r3 = out.roots[3] = Ops::pick(swap, a_out, e_out);
    if (Ops::any(out.four)) {
        const auto order = [&](T& low, T& high) {
            const typename Ops::Bool wrong = Ops::both(out.four, high < low);
            const T first = low;
            low = Ops::pick(wrong, high, low);
            high = Ops::pick(wrong, first, high);
        };
        order(r1, r2);
        order(r2, r3);
    }
    polish<Ops>(curve, true, out.two, r0, out.safe);
    polish<Ops>(curve, false, out.two, r1, out.safe);
    out.safe = Ops::both(out.safe, Ops::either(!out.two, r1 > r0));
    if (!Ops::any(out.four)) return out;
    polish<Ops>(curve, true, out.four, r2, out.safe);
    polish<Ops>(curve, false, out.four, r3, out.safe);
    out.safe = Ops::both(out.safe, Ops::either(!out.four, Ops::both(r2 > r1, r3 > r2)));
    return out;
}

}  // namespace csg::detail
