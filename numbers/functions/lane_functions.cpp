#include "numbers/functions/lane_functions.h"
#include "numbers/functions/angles.h"
#include "numbers/functions/logarithms.h"
#include "numbers/functions/sines.h"

/// Numbers in lanes: the quick way for all, and one by one those that it is not made for.
namespace numbers {

namespace {

using lanes::mask;

template <class One, class... V>
[[gnu::noinline, gnu::cold]] Double one_by_one(Double out, std::uint32_t which, One&& one, const V&... of)
{
    for (int lane = 0; lane < lanes::kDoubles; ++lane)
        if ((which >> lane & 1u) != 0) {
            const auto n = static_cast<std::size_t>(lane);
            const auto at = [n](const Double& v) {
                alignas(64) std::array<double, static_cast<std::size_t>(lanes::kDoubles)> all;
                v.store_aligned(all.data());
                return all[n];
            };
            alignas(64) std::array<double, static_cast<std::size_t>(lanes::kDoubles)> all;
            out.store_aligned(all.data());
            all[n] = one(at(of)...);
            out = Double::load_aligned(all.data());
        }
    return out;
}

/// The quick values where `plain`, the others by `one`.
template <class Bool, class One, class... V>
Double completed(const Double& quick, const Bool& plain, One&& one, const V&... of)
{
    constexpr std::uint32_t kAll = (1u << lanes::kDoubles) - 1u;
    const std::uint32_t left = ~mask(plain) & kAll;
    if (left == 0) [[likely]]
        return quick;
    return one_by_one(quick, left, one, of...);
}

/// e^x out of its quick value; beyond the ends of a double it needs no other.
template <class Bool, class One, class... V>
Double exponential_value(const Double& x, const Double& quick, const Bool& plain, One&& one, const V&... of)
{
    const auto none = x<Double(kLeastExponent), infinite = x> Double(kMostExponent);
    const Double ended = xsimd::select(none, Double(0.0), Double(std::numeric_limits<double>::infinity()));
    const auto outside = none | infinite;
    const auto quickly = xsimd::abs(x) < Double(kMostQuickExponent);
    return completed(xsimd::select(outside, ended, quick), plain & (outside | quickly), one, of...);
}

auto smaller_than(const Double& v, double limit) { return xsimd::abs(v) < Double(limit); }

}  // namespace

#define OF_ONE(name) [](auto... v) { return numbers::name(v...); }

[[gnu::flatten]] Double sin(const Double& x)
{
    return completed(quick_sine(x, turned(x)), smaller_than(x, kMostQuickAngle), OF_ONE(sin), x);
}
[[gnu::flatten]] Double cos(const Double& x)
{
    return completed(quick_cosine(turned(x)), smaller_than(x, kMostQuickAngle), OF_ONE(cos), x);
}
[[gnu::flatten]] Double tan(const Double& x)
{
    return completed(quick_tangent(x, turned(x)), smaller_than(x, kMostQuickAngle), OF_ONE(tan), x);
}
[[gnu::flatten]] Double asin(const Double& x) { return quick_asin(x); }
[[gnu::flatten]] Double acos(const Double& x) { return quick_acos(x); }
[[gnu::flatten]] Double atan(const Double& x)
{
    return completed(quick_atan(x), smaller_than(x, kMostQuickSize), OF_ONE(atan), x);
}
[[gnu::flatten]] Double atan2(const Double& y, const Double& x)
{
    const auto plain = in_quick_range(size_of(y)) & in_quick_range(size_of(x));
    return completed(quick_atan2(y, x), plain, OF_ONE(atan2), y, x);
}
[[gnu::flatten]] Double exp(const Double& x)
{
    return exponential_value(x, quick_value(exponential_of(x, Double(0.0))), x == x, OF_ONE(exp), x);
}
[[gnu::flatten]] Double log(const Double& x) { return completed(quick_logarithm(x), is_plain(x), OF_ONE(log), x); }
[[gnu::flatten]] Double log10(const Double& x)
{
    return completed(quick_logarithm(x, kPerLn10), is_plain(x), OF_ONE(log10), x);
}
[[gnu::flatten]] Double pow(const Double& x, const Double& y)
{
    const Pair<Double> e = exponent_of(logarithm_of(x, Double(0.0)), y);
    const auto of_nothing = (x == Double(0.0)) & (signed_as(Double(1.0), x) > Double(0.0)) & (y > Double(0.0));
    const Double exponent = xsimd::select(of_nothing, Double(-std::numeric_limits<double>::infinity()), e.high);
    const Double quick = quick_value(exponential_of(e.high, e.low));
    return exponential_value(exponent, quick, is_plain(x) | of_nothing, OF_ONE(pow), x, y);
}
[[gnu::flatten]] Double sinh(const Double& x)
{
    return completed(quick_sinh(x), smaller_than(x, kMostQuickExponent), OF_ONE(sinh), x);
}
[[gnu::flatten]] Double cosh(const Double& x)
{
    return completed(quick_cosh(x), smaller_than(x, kMostQuickExponent), OF_ONE(cosh), x);
}
[[gnu::flatten]] Double tanh(const Double& x)
{
    return completed(quick_tanh(x), smaller_than(x, kMostQuickExponent), OF_ONE(tanh), x);
}
[[gnu::flatten]] Double asinh(const Double& x)
{
    return completed(quick_asinh(x), smaller_than(x, kMostSquared), OF_ONE(asinh), x);
}
[[gnu::flatten]] Double acosh(const Double& x)
{
    const auto plain = (Double(1.0) <= x) & (x < Double(kMostSquared));
    return completed(quick_acosh(x), plain, OF_ONE(acosh), x);
}
[[gnu::flatten]] Double atanh(const Double& x)
{
    return completed(quick_atanh(x), smaller_than(x, 1.0), OF_ONE(atanh), x);
}

[[gnu::flatten]] Double hypot(const Double& x, const Double& y)
{
    const Double a = size_of(x), b = size_of(y);
    return completed(quick_hypot(a, b), in_quick_range(a) & in_quick_range(b), OF_ONE(hypot), x, y);
}
[[gnu::flatten]] SineAndCosine<Double> sine_and_cosine(const Double& x)
{
    const Turned<Double> of = turned(x);
    const auto plain = smaller_than(x, kMostQuickAngle);
    return {completed(quick_sine(x, of), plain, OF_ONE(sin), x), completed(quick_cosine(of), plain, OF_ONE(cos), x)};
}
[[gnu::flatten]] SineAndCosine<Double> hyperbolic(const Double& x)
{
    const SineAndCosine<Double> of = quick_hyperbolic(x);
    const auto plain = smaller_than(x, kMostQuickExponent);
    return {completed(of.sine, plain, OF_ONE(sinh), x), completed(of.cosine, plain, OF_ONE(cosh), x)};
}

}  // namespace numbers
