#include "numbers/functions/functions.h"
#include "numbers/functions/angles.h"
#include "numbers/functions/logarithms.h"
#include "numbers/functions/far_angle.h"

#include <limits>

/// One number: what the templates leave out is finished here.
namespace numbers {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();

template <class Quick>
double of_angle(double x, Quick&& quick)
{
    if (std::abs(x) < kMostQuickAngle) [[likely]]
        return quick(turned(x));
    return std::isfinite(x) ? quick(turned_far(x)) : kNan;
}

Pair<double> logarithm_of_size(double size)
{
    if (is_plain(size)) return logarithm_of(size, 0.0);
    return logarithm_of(size * 0x1p54, 0.0) + kLn2 * Pair<double>{-54.0, 0.0};
}

template <class F>
double of_logarithm(double x, F&& f)
{
    if (x > 0.0 && x < kInf) [[likely]]
        return f(logarithm_of_size(x));
    return x == 0.0 ? -kInf : x < 0.0 ? kNan : x;
}

bool is_whole(double v) { return std::trunc(v) == v; }
bool is_odd(double v) { return is_whole(v) && !is_whole(0.5 * v); }

/// x^y where x is 0, infinite or no number, or y is one of the latter.
double special_power(double x, double y)
{
    if (std::isnan(x) || std::isnan(y)) return kNan;
    if (std::isinf(y)) {
        const double size = std::abs(x);
        return size == 1.0 ? 1.0 : (size > 1.0) == (y > 0.0) ? kInf : 0.0;
    }
    const double out = (std::abs(x) > 1.0) == (y > 0.0) ? kInf : 0.0;
    return std::signbit(x) && is_odd(y) ? -out : out;
}

}  // namespace

[[gnu::flatten]] double sin(double x)
{
    return of_angle(x, [&](const Turned<double>& of) { return quick_sine(x, of); });
}
[[gnu::flatten]] double cos(double x)
{
    return of_angle(x, [&](const Turned<double>& of) { return quick_cosine(of); });
}
[[gnu::flatten]] SineAndCosine<double> sine_and_cosine(double x)
{
    if (!(std::abs(x) < kMostQuickAngle)) [[unlikely]]
        return {sin(x), cos(x)};
    const Turned<double> of = turned(x);
    return {quick_sine(x, of), quick_cosine(of)};
}
[[gnu::flatten]] double tan(double x)
{
    return of_angle(x, [&](const Turned<double>& of) { return quick_tangent(x, of); });
}

[[gnu::flatten]] double asin(double x) { return quick_asin(x); }
[[gnu::flatten]] double acos(double x) { return quick_acos(x); }
[[gnu::flatten]] double atan(double x)
{
    if (std::abs(x) < kMostQuickSize) [[likely]]
        return quick_atan(x);
    return std::isnan(x) ? x : std::copysign(kHalfPi.high, x);
}

[[gnu::flatten]] double atan2(double y, double x)
{
    const double a = std::abs(x), b = std::abs(y);
    if (in_quick_range(a) && in_quick_range(b)) [[likely]]
        return quick_atan2(y, x);
    if (std::isnan(x) || std::isnan(y)) return kNan;
    const bool left = std::signbit(x);
    const double straight = left ? 2.0 * kHalfPi.high : 0.0;
    if (b == 0.0) return std::copysign(straight, y);
    if (std::isinf(a) && std::isinf(b)) return std::copysign((left ? 1.5 : 0.5) * kHalfPi.high, y);
    // Of one of the sizes, two bits are enough where the other is so much greater.
    if (a == 0.0 || std::isinf(b)) return std::copysign(kHalfPi.high, y);
    if (std::isinf(a)) return std::copysign(straight, y);
    const int of_x = std::ilogb(x), of_y = std::ilogb(y);
    if (of_y > of_x + 100) return std::copysign(kHalfPi.high, y);
    if (of_x > of_y + 100) return left ? std::copysign(straight, y) : y / x;
    return quick_atan2(std::ldexp(y, -of_y), std::ldexp(x, -of_y));
}

[[gnu::flatten]] double exp(double x)
{
    if (std::abs(x) < kMostQuickExponent) [[likely]]
        return quick_value(exponential_of(x, 0.0));
    if (std::isnan(x)) return x;
    return x > kMostExponent ? kInf : x < kLeastExponent ? 0.0 : value(exponential_of(x, 0.0));
}

[[gnu::flatten]] double log(double x)
{
    return is_plain(x) ? quick_logarithm(x) : of_logarithm(x, [](const Pair<double>& v) { return v.high; });
}
[[gnu::flatten]] double log2(double x)
{
    return of_logarithm(x, [](const Pair<double>& v) { return (v * kPerLn2).high; });
}
[[gnu::flatten]] double log10(double x)
{
    return of_logarithm(x, [](const Pair<double>& v) { return (v * kPerLn10).high; });
}

[[gnu::flatten]] double pow(double x, double y)
{
    if (is_plain(x)) [[likely]] {
        const Pair<double> e = exponent_of(logarithm_of(x, 0.0), y);
        if (std::abs(e.high) < kMostQuickExponent) [[likely]]
            return quick_value(exponential_of(e.high, e.low));
    }
    if (y == 0.0 || x == 1.0) return 1.0;
    if (x == 0.0 || !std::isfinite(x) || !std::isfinite(y)) return special_power(x, y);
    if (x < 0.0 && !is_whole(y)) return kNan;
    const double sign = x < 0.0 && is_odd(y) ? -1.0 : 1.0;
    const Pair<double> e = exponent_of(logarithm_of_size(std::abs(x)), y);
    if (e.high > kMostExponent) return sign * kInf;
    return e.high < kLeastExponent ? sign * 0.0 : sign * value(exponential_of(e.high, e.low));
}

namespace {
/// e^size / 2 where e^-size does not count; its own exponent may be too great.
double half_exponential(double size)
{
    if (size > 712.0) return kInf;
    Scaled<double> e = exponential_of(size, 0.0);
    e.step -= kPowerSteps;
    return value(e);
}
}  // namespace

[[gnu::flatten]] double sinh(double x)
{
    if (std::abs(x) < kMostQuickExponent) [[likely]]
        return quick_sinh(x);
    return std::isnan(x) ? x : std::copysign(half_exponential(std::abs(x)), x);
}
[[gnu::flatten]] double cosh(double x)
{
    if (std::abs(x) < kMostQuickExponent) [[likely]]
        return quick_cosh(x);
    return std::isnan(x) ? x : half_exponential(std::abs(x));
}
[[gnu::flatten]] SineAndCosine<double> hyperbolic(double x)
{
    if (std::abs(x) < kMostQuickExponent) [[likely]]
        return quick_hyperbolic(x);
    return {sinh(x), cosh(x)};
}
[[gnu::flatten]] double tanh(double x) { return std::isnan(x) ? x : quick_tanh(x); }

[[gnu::flatten]] double asinh(double x)
{
    const double a = std::abs(x);
    if (a < kMostSquared) [[likely]]
        return quick_asinh(x);
    return std::isfinite(x) ? std::copysign((logarithm_of(a, 0.0) + kLn2).high, x) : x;
}
[[gnu::flatten]] double acosh(double x)
{
    if (x >= 1.0 && x < kMostSquared) [[likely]]
        return quick_acosh(x);
    return x < 1.0 ? kNan : std::isfinite(x) ? (logarithm_of(x, 0.0) + kLn2).high : x;
}
[[gnu::flatten]] double atanh(double x)
{
    const double a = std::abs(x);
    if (a < 1.0) [[likely]]
        return quick_atanh(x);
    return a == 1.0 ? std::copysign(kInf, x) : kNan;
}

[[gnu::flatten]] double hypot(double x, double y)
{
    const double a = std::abs(x), b = std::abs(y), most = std::fmax(a, b), least = std::fmin(a, b);
    if (in_quick_range(most) && in_quick_range(least)) [[likely]]
        return quick_hypot(a, b);
    if (std::isinf(a) || std::isinf(b)) return kInf;
    if (std::isnan(a) || std::isnan(b)) return kNan;
    if (least == 0.0 || most > 0x1p100 * least) return most;
    const int by = std::ilogb(most);
    return std::ldexp(quick_hypot(std::ldexp(most, -by), std::ldexp(least, -by)), by);
}
double hypot(double x, double y, double z)
{
    const double a = std::abs(x), b = std::abs(y), c = std::abs(z), most = std::fmax(a, std::fmax(b, c));
    if (most == 0.0) return 0.0;
    const double u = a / most, v = b / most, w = c / most;
    return most * std::sqrt(u * u + v * v + w * w);
}

float exp(float x) { return static_cast<float>(exp(static_cast<double>(x))); }
[[gnu::flatten]] float pow(float x, float y)
{
    const auto base = static_cast<double>(x), power = static_cast<double>(y);
    // A float needs no more than half of a double's bits.
    const double e = is_plain(base) ? power * quick_logarithm(base) : kNan;
    return static_cast<float>(std::abs(e) < kMostQuickExponent ? quick_value(exponential_of(e, 0.0))
                                                               : pow(base, power));
}
float hypot(float x, float y)
{
    const auto a = static_cast<double>(x), b = static_cast<double>(y);
    return static_cast<float>(std::sqrt(a * a + b * b));
}

}  // namespace numbers
