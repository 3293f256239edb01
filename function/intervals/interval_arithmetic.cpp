#include "function/intervals/interval_arithmetic.h"
#include "numbers/functions/functions.h"

#include <cmath>
#include <numbers>

namespace function {
namespace {

using std::numbers::pi;

Interval truth(bool can_fail, bool can_hold) { return {can_fail ? 0.0 : 1.0, can_hold ? 1.0 : 0.0}; }

/// Least and greatest of f at the corners, for an f that is monotone in each variable.
template <class F>
Interval of_corners(const Interval& a, const Interval& b, F&& f)
{
    const double v[] = {f(a.low, b.low), f(a.low, b.high), f(a.high, b.low), f(a.high, b.high)};
    for (const double one : v)
        if (std::isnan(one)) return Interval::everything();
    return widened(*std::min_element(v, v + 4), *std::max_element(v, v + 4));
}

/// Products of 0 and infinity are 0 here: the infinite end stands for large numbers.
double product(double a, double b) { return a == 0.0 || b == 0.0 ? 0.0 : a * b; }

/// sin(x + shift) for x in a.
Interval sine(const Interval& a, double shift)
{
    constexpr double kLargest = 1e6;  // beyond it the turn is not known well enough
    if (!(a.high - a.low < 2.0 * pi) || std::abs(a.low) > kLargest || std::abs(a.high) > kLargest) return {-1.0, 1.0};
    constexpr double kSlack = 1e-9;  // a maximum as near as this is taken to be inside
    const auto holds = [&](double place) {
        const double turn = std::ceil((a.low + shift - place - kSlack) / (2.0 * pi));
        return turn * 2.0 * pi + place <= a.high + shift + kSlack;
    };
    const double l = numbers::sin(a.low + shift), h = numbers::sin(a.high + shift);
    constexpr double kShiftError = 1e-9;  // of x + shift, generously
    return {holds(-pi / 2) ? -1.0 : std::max(-1.0, std::min(l, h) - kShiftError),
            holds(pi / 2) ? 1.0 : std::min(1.0, std::max(l, h) + kShiftError)};
}

Interval arc_tangent(const Interval& y, const Interval& x)
{
    if (x.low <= 0.0 && y.contains(0.0)) return widened(-pi, pi);
    return of_corners(y, x, [](double a, double b) { return numbers::atan2(a, b); });
}

Interval modulo(const Interval& a, const Interval& b)
{
    if (b.point() && b.low != 0.0 && std::isfinite(b.low) && std::isfinite(a.low) && std::isfinite(a.high)) {
        constexpr double kWhole = 1e15;
        const double first = std::trunc(a.low / b.low), last = std::trunc(a.high / b.low);
        if (first == last && std::abs(first) < kWhole && a.low * a.high > 0.0) {
            const double l = std::fmod(a.low, b.low), h = std::fmod(a.high, b.low);
            if (l <= h) return widened(l, h);
        }
    }
    const double most = std::max(std::abs(b.low), std::abs(b.high));
    return {a.low < 0.0 ? -most : 0.0, a.high > 0.0 ? most : 0.0};
}

Interval power(const Interval& a, const Interval& b)
{
    const auto pow = [](double x, double y) { return numbers::pow(x, y); };
    if (a.low > 0.0) return of_corners(a, b, pow);
    if (b.point() && b.low == std::floor(b.low) && b.low >= 0.0) {
        if (std::fmod(b.low, 2.0) != 0.0) return of_corners(a, b, pow);
        const double most = std::max(std::abs(a.low), std::abs(a.high)),
                     least = a.contains(0.0) ? 0.0 : std::min(std::abs(a.low), std::abs(a.high));
        return widened(numbers::pow(least, b.low), numbers::pow(most, b.low));
    }
    if (b.low >= 0.0 && b.point() && a.high >= 0.0) return widened(0.0, numbers::pow(a.high, b.low));
    return Interval::everything();
}

/// f grows with its argument on [from, to]; outside it has no value.
template <class F>
Interval growing(const Interval& a, F&& f, double from = -kInf, double to = kInf)
{
    if (a.high < from || a.low > to) return Interval::everything();
    return widened(f(std::max(a.low, from)), f(std::min(a.high, to)));
}

}  // namespace

Interval absolute(const Interval& a)
{
    const double l = std::abs(a.low), h = std::abs(a.high);
    return {a.contains(0.0) ? 0.0 : std::min(l, h), std::max(l, h)};
}

Interval widened(double low, double high)
{
    // Of an end that is infinite on the wrong side nothing is left, as of what is no number.
    const double l = low - (std::abs(low) * kRelative + kAbsolute), h = high + (std::abs(high) * kRelative + kAbsolute);
    return std::isnan(l) || std::isnan(h) ? Interval::everything() : Interval{l, h};
}

Interval operator+(const Interval& a, const Interval& b) { return widened(a.low + b.low, a.high + b.high); }
Interval operator-(const Interval& a, const Interval& b) { return widened(a.low - b.high, a.high - b.low); }
Interval operator*(const Interval& a, const Interval& b) { return of_corners(a, b, product); }
Interval operator/(const Interval& a, const Interval& b)
{
    if (b.contains(0.0)) return Interval::everything();
    return of_corners(a, b, [](double x, double y) { return x / y; });
}
Interval squared(const Interval& a)
{
    const Interval s = absolute(a);
    return widened(s.low * s.low, s.high * s.high);
}
Interval sqrt(const Interval& a) { return interval_unary(Op::Sqrt, a); }
Interval field_limit(const Interval& a)
{
    return {std::min(10.0, std::max(-10.0, a.low)), std::min(10.0, std::max(-10.0, a.high))};
}

Interval interval_binary(Op op, const Interval& a, const Interval& b)
{
    const auto zero = [](const Interval& v) { return v.contains(0.0); };
    const auto other = [](const Interval& v) { return v.low != 0.0 || v.high != 0.0; };
    switch (op) {
    case Op::Add: return a + b;
    case Op::Subtract: return a - b;
    case Op::Multiply: return a * b;
    case Op::Divide: return a / b;
    case Op::Less: return truth(a.high >= b.low, a.low < b.high);
    case Op::LessEqual: return truth(a.high > b.low, a.low <= b.high);
    case Op::Greater: return truth(a.low <= b.high, a.high > b.low);
    case Op::GreaterEqual: return truth(a.low < b.high, a.high >= b.low);
    case Op::Equal: return truth(!(a.point() && b.point() && a.low == b.low), a.low <= b.high && b.low <= a.high);
    case Op::NotEqual: return truth(a.low <= b.high && b.low <= a.high, !(a.point() && b.point() && a.low == b.low));
    case Op::And: return truth(zero(a) || zero(b), other(a) && other(b));
    case Op::Or: return truth(zero(a) && zero(b), other(a) || other(b));
    case Op::Min: return {std::min(a.low, b.low), std::min(a.high, b.high)};
    case Op::Max: return larger(a, b);
    case Op::Atan2: return arc_tangent(a, b);
    case Op::IntDivide: return interval_unary(Op::Int, a / b);
    case Op::Modulo: return modulo(a, b);
    default: return power(a, b);
    }
}

Interval interval_unary(Op op, const Interval& a)
{
    const auto f = [op](double v) { return apply(op, v); };
    switch (op) {
    case Op::Negate: return {-a.high, -a.low};
    case Op::Abs: return absolute(a);
    case Op::Ceil: return {std::ceil(a.low), std::ceil(a.high)};
    case Op::Floor: return {std::floor(a.low), std::floor(a.high)};
    case Op::Int: {
        const bool fits = a.low > -2147483649.0 && a.high < 2147483648.0;
        return fits ? Interval{std::trunc(a.low), std::trunc(a.high)} : Interval{-2147483648.0, 2147483647.0};
    }
    case Op::Sin: return sine(a, 0.0);
    case Op::Cos: return sine(a, pi / 2);
    case Op::Tan: {
        const bool one_branch = std::floor(a.low / pi + 0.5) == std::floor(a.high / pi + 0.5) && std::abs(a.low) < 1e6;
        const double l = numbers::tan(a.low), h = numbers::tan(a.high);
        return one_branch && l <= h ? widened(l, h) : Interval::everything();
    }
    case Op::Cosh: {
        const Interval s = absolute(a);
        return widened(numbers::cosh(s.low), numbers::cosh(s.high));
    }
    case Op::Sqrt:
    case Op::Ln:
    case Op::Log: return growing(a, f, 0.0);
    case Op::Acosh: return growing(a, f, 1.0);
    case Op::Asin:
    case Op::Atanh: return growing(a, f, -1.0, 1.0);
    case Op::Acos: {
        if (a.high < -1.0 || a.low > 1.0) return Interval::everything();
        return widened(numbers::acos(std::min(a.high, 1.0)), numbers::acos(std::max(a.low, -1.0)));
    }
    default: return growing(a, f);  // asinh, atan, degrees, exp, radians, sinh, tanh
    }
}

}  // namespace function
