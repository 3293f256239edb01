#pragma once

#include "numbers/lane_power.h"
#include "function/intervals/angle_lanes.h"
#include "function/intervals/interval_arithmetic.h"

#include <bit>
#include <numbers>

/// Intervals in the lanes of a register, and what arithmetic and the library's functions make of them. Steps are
/// always taken in: a call would send each operand through memory.
namespace function {

struct Ends {
    Batch low, high;
    Ends() = default;
    Ends(const Batch& l, const Batch& h) : low(l), high(h) {}
    Ends(double v) : low(v), high(v) {}  // implicit: constants of formulas
};

[[gnu::always_inline]] inline Batch below(const Batch& v)
{
    return v - (xsimd::abs(v) * Batch(kRelative) + Batch(kAbsolute));
}
[[gnu::always_inline]] inline Batch above(const Batch& v)
{
    return v + (xsimd::abs(v) * Batch(kRelative) + Batch(kAbsolute));
}

/// With room for rounding; what is no number may be any.
[[gnu::always_inline]] inline Ends widened(const Batch& low, const Batch& high)
{
    const Batch l = below(low), h = above(high);
    const auto known = (l == l) & (h == h);
    return {xsimd::select(known, l, Batch(-kInf)), xsimd::select(known, h, Batch(kInf))};
}

/// 0 times infinity is 0: the infinite end stands for large numbers.
[[gnu::always_inline]] inline Batch finite_product(const Batch& a, const Batch& b)
{
    const Batch p = a * b;
    return xsimd::select(p == p, p, Batch(0.0));
}

[[gnu::always_inline]] inline Ends multiply(const Ends& a, const Ends& b)
{
    const Batch p = finite_product(a.low, b.low), q = finite_product(a.low, b.high), r = finite_product(a.high, b.low),
                s = finite_product(a.high, b.high);
    return widened(xsimd::min(xsimd::min(p, q), xsimd::min(r, s)), xsimd::max(xsimd::max(p, q), xsimd::max(r, s)));
}

[[gnu::always_inline]] inline Ends absolute(const Ends& a)
{
    const Batch l = xsimd::abs(a.low), h = xsimd::abs(a.high);
    const auto through = (a.low <= Batch(0.0)) & (a.high >= Batch(0.0));
    return {xsimd::select(through, Batch(0.0), xsimd::min(l, h)), xsimd::max(l, h)};
}

/// The square of what is written twice.
[[gnu::always_inline]] inline Ends squared(const Ends& a)
{
    const Ends s = absolute(a);
    const Ends out = widened(s.low * s.low, s.high * s.high);
    return {xsimd::max(out.low, Batch(0.0)), out.high};
}

/// No root of a wholly negative number: it may be any.
[[gnu::always_inline]] inline Ends sqrt(const Ends& a)
{
    return widened(xsimd::sqrt(xsimd::max(a.low, Batch(0.0))), xsimd::sqrt(a.high));
}
[[gnu::always_inline]] inline Ends larger(const Ends& a, const Ends& b)
{
    return {xsimd::max(a.low, b.low), xsimd::max(a.high, b.high)};
}
[[gnu::always_inline]] inline Ends field_limit(const Ends& a)
{
    const auto limit = [](const Batch& v) { return xsimd::min(Batch(10.0), xsimd::max(Batch(-10.0), v)); };
    return {limit(a.low), limit(a.high)};
}
[[gnu::always_inline]] inline Ends operator+(const Ends& a, const Ends& b)
{
    return widened(a.low + b.low, a.high + b.high);
}
[[gnu::always_inline]] inline Ends operator-(const Ends& a, const Ends& b)
{
    return widened(a.low - b.high, a.high - b.low);
}
// A number times itself is no product of two.
[[gnu::always_inline]] inline Ends operator*(const Ends& a, const Ends& b)
{
    return &a == &b ? squared(a) : multiply(a, b);
}

[[gnu::always_inline]] inline Ends divide(const Ends& a, const Ends& b)
{
    const auto through = (b.low <= Batch(0.0)) & (b.high >= Batch(0.0));
    const Batch p = a.low / b.low, q = a.low / b.high, r = a.high / b.low, s = a.high / b.high;
    const auto known = (p == p) & (q == q) & (r == r) & (s == s);
    const Ends w =
        widened(xsimd::min(xsimd::min(p, q), xsimd::min(r, s)), xsimd::max(xsimd::max(p, q), xsimd::max(r, s)));
    const auto good = known & !through;
    return {xsimd::select(good, w.low, Batch(-kInf)), xsimd::select(good, w.high, Batch(kInf))};
}

/// Every step of rounded_box() rises or falls with each of its operands all the way, rounded or not: at the ends of a
/// box it has the ends of its values, to the bit.
inline Ends rounded_box_ends(const Ends* a)
{
    const Batch zero(0.0);
    struct Squares {
        Batch low, high;
    };
    const auto beyond = [&](int k) {
        const Ends size = absolute(a[k]);
        const Batch low = xsimd::max(zero, size.low - (a[4 + k].high - a[3].low)),
                    high = xsimd::max(zero, size.high - (a[4 + k].low - a[3].high));
        return Squares{low * low, high * high};
    };
    const Squares x = beyond(0), y = beyond(1), z = beyond(2);
    const Batch low = xsimd::sqrt(x.low + y.low + z.low) - a[3].high - Batch(1e-6),
                high = xsimd::sqrt(x.high + y.high + z.high) - a[3].low - Batch(1e-6);
    // max() may drop what is no number.
    const auto is_number = [&](int k) { return (a[k].low == a[k].low) & (a[k].high == a[k].high); };
    const auto known = is_number(0) & is_number(1) & is_number(2) & (low == low) & (high == high);
    return {xsimd::select(known, low, Batch(-kInf)), xsimd::select(known, high, Batch(kInf))};
}

/// Some value for the lanes of `where`, the function's own for the others.
inline Ends or_all(const Batch::batch_bool_type& where, double low, double high, const Ends& others)
{
    return {xsimd::select(where, Batch(low), others.low), xsimd::select(where, Batch(high), others.high)};
}

/// sin(x + shift) for x in a, with more room than sine() of one interval has.
inline Ends sine(const Ends& a, double shift)
{
    constexpr double kLargest = 1e6;                                 // beyond it the turn is not known well enough
    constexpr double kTurn = 0.5 / std::numbers::pi, kSlack = 1e-9;  // of a turn: far above its error
    const auto known = (a.high - a.low < Batch(1.0 / kTurn)) & (xsimd::abs(a.low) <= Batch(kLargest)) &
                       (xsimd::abs(a.high) <= Batch(kLargest));
    const Batch from = (a.low + Batch(shift)) * Batch(kTurn), to = (a.high + Batch(shift)) * Batch(kTurn);
    // Whether a turn of `place` lies between.
    const auto holds = [&](double place) {
        const Batch turn = xsimd::ceil(from - Batch(place + kSlack));
        return turn + Batch(place) <= to + Batch(kSlack);
    };
    const Batch l = sine_of_turn(from), h = sine_of_turn(to), one(1.0), room(1e-8);
    const Ends out{xsimd::select(holds(-0.25), -one, xsimd::max(-one, xsimd::min(l, h) - room)),
                   xsimd::select(holds(0.25), one, xsimd::min(one, xsimd::max(l, h) + room))};
    return or_all(!known, -1.0, 1.0, out);
}

inline Ends arc_tangent(const Ends& y, const Ends& x)
{
    const Batch p = angle_of(y.low, x.low), q = angle_of(y.low, x.high), r = angle_of(y.high, x.low),
                s = angle_of(y.high, x.high), room(kAngleError);
    const auto known = (p == p) & (q == q) & (r == r) & (s == s),
               around = (x.low <= Batch(0.0)) & (y.low <= Batch(0.0)) & (y.high >= Batch(0.0));
    const Ends out{xsimd::min(xsimd::min(p, q), xsimd::min(r, s)) - room,
                   xsimd::max(xsimd::max(p, q), xsimd::max(r, s)) + room};
    constexpr double kHalf = std::numbers::pi + kAngleError;
    return or_all(around, -kHalf, kHalf, or_all(!known, -kInf, kInf, out));
}

// Series of powers are cut off where boxes need no more: their ends lie farther apart than what is left out.
inline constexpr double kLogarithmError = 2e-11;

/// Logarithms of both ends, by one division.
[[gnu::always_inline]] inline Ends logarithms(const Batch& low, const Batch& high)
{
    constexpr std::size_t kTerms = 5;  // what is left out is below 1.9e-11
    const auto l = numbers::lanes::scaled(low), h = numbers::lanes::scaled(high);
    const Batch one(1.0), under_l = l.mantissa + one, under_h = h.mantissa + one, part = one / (under_l * under_h);
    return {numbers::lanes::logarithm_by<kTerms>((l.mantissa - one) * (under_h * part), l.exponent),
            numbers::lanes::logarithm_by<kTerms>((h.mantissa - one) * (under_l * part), h.exponent)};
}

/// Below and above e^x, for x = from and x = to, which are off by at most `error`. Beyond the series' range 0 and
/// infinity.
[[gnu::always_inline]] inline Ends exponential_between(const Batch& from, const Batch& to, double error)
{
    constexpr std::size_t kTerms = 7;
    constexpr double kMost = 699.0, kSeries = 4e-10;  // above the error of the series, of numbers up to 699 as well
    const double room = kSeries + 2.0 * error;
    const auto inside = [](const Batch& v) { return xsimd::min(Batch(kMost), xsimd::max(Batch(-kMost), v)); };
    const Ends out{numbers::lanes::exponential<kTerms>(inside(from)) * Batch(1.0 - room),
                   numbers::lanes::exponential<kTerms>(inside(to)) * Batch(1.0 + room)};
    return {xsimd::select(from >= Batch(-kMost), out.low, Batch(0.0)),
            xsimd::select(to <= Batch(kMost), out.high, Batch(kInf))};
}

/// e^x.
[[gnu::always_inline]] inline Ends exponential(const Ends& a) { return exponential_between(a.low, a.high, 0.0); }

/// x^exponent of what x is at or above 0, whatever of it lies below left out; everything where nothing is left.
inline Ends power(const Ends& a, double exponent)
{
    constexpr double kLeast = 1e-300, kMost = 1e300;
    if (exponent == 0.0) return 1.0;
    const auto inside = [](const Batch& v) { return xsimd::min(Batch(kMost), xsimd::max(Batch(kLeast), v)); };
    const Ends size = logarithms(inside(a.low), inside(a.high));
    const double error = std::abs(exponent) * kLogarithmError;
    const Batch zero(0.0), infinity(kInf), from = Batch(exponent) * size.low, to = Batch(exponent) * size.high;
    const auto known = (a.low == a.low) & (a.high >= zero), tiny = a.low<Batch(kLeast), huge = a.high> Batch(kMost);
    Ends out;
    if (exponent > 0.0) {
        out = exponential_between(from, to, error);
        out = {xsimd::select(tiny, zero, out.low), xsimd::select(huge, infinity, out.high)};
    } else {
        out = exponential_between(to, from, error);
        out = {xsimd::select(huge, zero, out.low), xsimd::select(tiny, infinity, out.high)};
    }
    return {xsimd::select(known, out.low, -infinity), xsimd::select(known, out.high, infinity)};
}

/// x^exponent of a whole exponent, as pow() has it.
inline Ends whole_power(const Ends& a, double exponent)
{
    if (std::fmod(exponent, 2.0) == 0.0) return power(absolute(a), exponent);
    const Ends up = power(a, exponent), down = power({-a.high, -a.low}, exponent);
    const auto positive = a.low >= Batch(0.0), negative = a.high <= Batch(0.0);
    const Batch between_low = exponent > 0.0 ? -down.high : Batch(-kInf),
                between_high = exponent > 0.0 ? up.high : Batch(kInf);
    return {xsimd::select(positive, up.low, xsimd::select(negative, -down.high, between_low)),
            xsimd::select(positive, up.high, xsimd::select(negative, -down.low, between_high))};
}

/// The remainder of x / b, which has x's sign; b is finite and not 0. Where x may pass a whole number of times b, or is
/// so near to one that rounding may have led past it, it may be any remainder.
inline Ends modulo(const Ends& a, double b)
{
    constexpr double kMostTurns = 1e15;
    const Batch size(std::abs(b)), zero(0.0);
    const Ends far = absolute(a);
    const Batch turns = xsimd::floor(far.low / size), room = far.high * Batch(kRelative);
    const Batch low = far.low - turns * size, high = far.high - turns * size;
    const auto negative = a.high < zero, one_sign = negative | (a.low > zero);
    const auto same = one_sign & (low >= room) & (high <= size - room) & (turns < Batch(kMostTurns));
    const auto itself = far.high < size;
    const Batch below = xsimd::select(a.low < zero, -size, zero), above = xsimd::select(a.high > zero, size, zero);
    const Ends turned = widened(xsimd::select(negative, -high, low) - room, xsimd::select(negative, -low, high) + room);
    const auto known = (a.low == a.low) & (a.high == a.high);
    return {xsimd::select(known, xsimd::select(itself, a.low, xsimd::select(same, turned.low, below)), -size),
            xsimd::select(known, xsimd::select(itself, a.high, xsimd::select(same, turned.high, above)), size)};
}

/// Whether all lanes are one number, the same.
inline bool is_constant(const Ends& a) { return xsimd::all((a.low == a.high) & (a.low == Batch(a.low.get(0)))); }

/// |x - m| for the nearest odd multiple m of half: between 0 and half, a wave of triangles (half above 0).
inline Ends from_odd_multiples(const Ends& a, double half)
{
    constexpr double kSlack = 1e-9, kLargest = 1e5;  // in turns
    const double turn = 1.0 / (2.0 * half);
    const Batch from = a.low * Batch(turn), to = a.high * Batch(turn);
    const auto known = (to - from < Batch(1.0)) & (xsimd::abs(from) < Batch(kLargest)) &
                       (xsimd::abs(to) < Batch(kLargest));
    const auto holds = [&](double place) {
        return xsimd::ceil(from - Batch(place + kSlack)) + Batch(place) <= to + Batch(kSlack);
    };
    const auto height = [](const Batch& v) { return xsimd::abs(v - xsimd::floor(v) - Batch(0.5)); };
    const Batch l = height(from), h = height(to), room(kSlack), zero(0.0), top(0.5);
    const Batch low = xsimd::select(holds(0.5), zero, xsimd::max(zero, xsimd::min(l, h) - room)),
                high = xsimd::select(holds(0.0), top, xsimd::min(top, xsimd::max(l, h) + room));
    const Batch scale(2.0 * half);
    return {xsimd::select(known, low, zero) * scale, xsimd::select(known, high, top) * scale * Batch(1.0 + kSlack)};
}

}  // namespace function
