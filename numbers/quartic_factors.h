#pragma once

#include "numbers/lane_arithmetic.h"

#include <bit>
#include <cstdint>

/// Quartics solved by factors: one, or one a lane.
namespace numbers::detail {

/// A positive number to about a tenth of its cube root: a third of the exponent. The series in quarters is for lanes,
/// which cannot divide integers.
template <class Bits>
inline Bits third_of_exponent(const Bits& number)
{
    Bits third = number >> 2;
    third += third >> 2;
    third += third >> 4;
    third += third >> 8;
    third += third >> 16;
    return third + Bits(std::uint64_t{0x2a9f7893782da1ce});
}
inline double cube_root_seed(double v)
{
    return std::bit_cast<double>(third_of_exponent(std::bit_cast<std::uint64_t>(v)));
}
inline lanes::Double cube_root_seed(const lanes::Double& v)
{
    return lanes::same_bits<lanes::Double>(third_of_exponent(lanes::same_bits<xsimd::batch<std::uint64_t>>(v)));
}

/// y of y^3 + 3 p y + 2 q with three real roots: y = 2 m cos(angle / 3), to 4e-7.
template <class V>
inline V largest_of_three(V p, V q)
{
    const V m = lanes::root_of(V(0.0) - p), x = (V(0.0) - q) / (m * m * m);
    // In u = cos(angle / 2) that is smooth on all of [0, 1]. cos(2/3 acos u): Chebyshev fit of degree 6.
    const V square = V(0.5) + V(0.5) * x, u = lanes::root_of(lanes::choose(square > V(0.0), square, V(0.0)));
    constexpr double kCosine[] = {0.5000003853121096,   0.5773274274111112,   -0.1107800277739088,  0.05142277070493927,
                                  -0.02636974636115907, 0.010521227858269878, -0.002122323277739942};
    V cosine(kCosine[6]);
    for (int i = 5; i >= 0; --i) cosine = V(kCosine[i]) + u * cosine;
    return V(2.0) * m * cosine;
}

/// The same with one real root, to about 1e-4: Cardano's formula with one step of Halley's for the cube root.
template <class V>
inline V only_root(V p, V q, V inside)
{
    const V w = lanes::size_of(q) + lanes::root_of(inside);
    const V seed = cube_root_seed(w), cube = seed * seed * seed;
    const V root = seed * (cube + V(2.0) * w) / (V(2.0) * cube + w), size = root - p / root;
    return lanes::choose(w > V(0.0), lanes::choose(q > V(0.0), V(0.0) - size, size), V(0.0));
}

/// The largest real root of z^3 + a z^2 + b z + c for c <= 0, which has one that is not negative. Roughly by formula,
/// then by Newton on the cubic as given: its value has no cancellation near 0.
template <class V>
inline V largest_root(V a, V b, V c)
{
    const V zero(0.0);
    const V third = a * V(1.0 / 3.0);
    const V p = b * V(1.0 / 3.0) - third * third,
            q = third * (third * third - V(0.5) * b) + V(0.5) * c;  // y^3 + 3 p y + 2 q
    const V inside = q * q + p * p * p;
    const lanes::Truth<V> three = inside < zero, one = !three;
    V y = zero;
    if (lanes::mask(three) != 0) y = largest_of_three(p, q);
    if (lanes::mask(one) != 0) y = lanes::choose(one, only_root(p, q, inside), y);
    V z = y - third;
    z = lanes::choose(z > zero, z, zero);
    auto active = z == z;
    for (int i = 0; i < 12; ++i) {
        const V slope = b + z * (V(2.0) * a + V(3.0) * z);
        active = active & (slope > zero);
        if (lanes::mask(active) == 0) break;
        const V step = (c + z * (b + z * (a + z))) / slope, next = z - step;
        z = lanes::choose(active, lanes::choose(next > zero, next, zero), z);
        active = active & !(lanes::size_of(step) <= V(1e-9) * z);  // the next one would be below rounding
    }
    return z;
}

/// What factors give: `safe` false asks for the search instead. Crossings in order, an even number: none, roots[0] and
/// [1] where `two`, all where `four`.
template <class V>
struct QuarticFactors {
    V roots[4];
    lanes::Truth<V> safe, two, four;
};

/// Newton on the surface itself; an even root is an entry, an odd one an exit. Clears `safe` where it is not.
template <class V, class Curve>
inline void polish(const Curve& curve, bool entry, lanes::Truth<V> active, V& root, lanes::Truth<V>& safe)
{
    for (int k = 0; k < 3 && lanes::mask(active) != 0; ++k) {
        V value(0.0), slope(0.0);
        curve.sheets(root, value, slope);
        const lanes::Truth<V> falls = slope < V(0.0);
        safe = safe & ((!active) | (entry ? falls : !falls));
        const V step = value / slope;
        root = lanes::choose(active, root - step, root);
        active = active & !(lanes::size_of(step) < V(1e-9));
    }
    safe = safe & !active;
}

/// Crossings from the two quadratic factors of the quartic (t^2 + h t + u)(t^2 - h t + v), where h^2 is the largest
/// root of the resolvent (Descartes; numerically as in Orellana and De Michele, ACM Algorithm 1010, 2020), each
/// polished. Not safe near tangents.
///
/// `curve`: square, linear and constant of t^4 + square t^2 + linear t + constant, whose roots are of order 1, and
/// sheets(t, value, slope) to polish with.
template <class V, class Curve>
inline QuarticFactors<V> quartic_by_factors(const Curve& curve)
{
    // Smaller discriminants than this part of their terms may have the wrong sign (measured).
    const V tangent(1e-6), zero(0.0);
    const V b = curve.square, c = curve.linear, d = curve.constant;
    const V z = largest_root(V(2.0) * b, b * b - V(4.0) * d, zero - c * c);
    const V h = lanes::root_of(z), sum = b + z, quarter = V(0.25) * z;
    // v - u: c / h, but from the product u v = d where h vanishes (rays along the axis or in the torus' plane).
    const V product = sum * sum - V(4.0) * d;
    const V apart =
        lanes::choose(z > V(1e-2), lanes::size_of(c) / h, lanes::root_of(lanes::choose(product > zero, product, zero)));
    const V difference = lanes::choose(c < zero, zero - apart, apart);
    const V u = V(0.5) * (sum - difference), v = V(0.5) * (sum + difference);
    const V below_u = quarter - u, below_v = quarter - v, half = V(0.5) * h;
    QuarticFactors<V> out;
    const lanes::Truth<V> sure_u = lanes::size_of(below_u) > tangent * (quarter + lanes::size_of(u)),
                          sure_v = lanes::size_of(below_v) > tangent * (quarter + lanes::size_of(v));
    out.safe = sure_u & sure_v;
    const lanes::Truth<V> has_u = below_u > zero, has_v = below_v > zero;
    out.two = out.safe & (has_u | has_v);
    out.four = out.two & has_u & has_v;
    if (lanes::mask(out.two) == 0) return out;
    const V reach_u = lanes::root_of(below_u), reach_v = lanes::root_of(below_v);
    V a = zero - half - reach_u, a_out = zero - half + reach_u, e = half - reach_v, e_out = half + reach_v;
    // The pair that is there comes first, or the one that begins first.
    const lanes::Truth<V> swap = (!has_u) | (out.four & (e < a));
    V& r0 = out.roots[0] = lanes::choose(swap, e, a);
    V& r1 = out.roots[1] = lanes::choose(swap, e_out, a_out);
    V& r2 = out.roots[2] = lanes::choose(swap, a, e);
    V& r3 = out.roots[3] = lanes::choose(swap, a_out, e_out);
    if (lanes::mask(out.four) != 0) {
        const auto order = [&](V& low, V& high) {
            const lanes::Truth<V> wrong = out.four & (high < low);
            const V first = low;
            low = lanes::choose(wrong, high, low);
            high = lanes::choose(wrong, first, high);
        };
        order(r1, r2);
        order(r2, r3);
    }
    polish(curve, true, out.two, r0, out.safe);
    polish(curve, false, out.two, r1, out.safe);
    out.safe = out.safe & ((!out.two) | (r1 > r0));
    if (lanes::mask(out.four) == 0) return out;
    polish(curve, true, out.four, r2, out.safe);
    polish(curve, false, out.four, r3, out.safe);
    out.safe = out.safe & ((!out.four) | ((r2 > r1) & (r3 > r2)));
    return out;
}

}  // namespace numbers::detail
