#pragma once

#include "csg/freeform/field/julia.h"
#include "numbers/functions/lane_functions.h"
#include "numbers/lane_arithmetic.h"

#include <cmath>

/// f of q -> f(q) + constant, in four dimensions (spec 5b, 12.1).
namespace csg::julia {

/// Complex numbers without the checks for what is no number; of one double or of lanes of them, to the same bits.
template <class T>
struct Complex {
    T re, im;
};
template <class T>
inline Complex<T> operator+(const Complex<T>& a, const Complex<T>& b)
{
    return {a.re + b.re, a.im + b.im};
}
template <class T>
inline Complex<T> operator-(const Complex<T>& a, const Complex<T>& b)
{
    return {a.re - b.re, a.im - b.im};
}
template <class T>
inline Complex<T> operator*(const Complex<T>& a, const Complex<T>& b)
{
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
template <class T>
inline Complex<T> operator/(const Complex<T>& a, const Complex<T>& b)
{
    const T n = b.re * b.re + b.im * b.im;
    return {(a.re * b.re + a.im * b.im) / n, (a.im * b.re - a.re * b.im) / n};
}
template <class T>
inline Complex<T> times_i(const Complex<T>& a)
{
    return {lanes::negated(a.im), a.re};
}
template <class T>
inline Complex<T> of_polar(const T& size, const T& angle)
{
    const auto turn = numbers::sine_and_cosine(angle);
    return {size * turn.cosine, size * turn.sine};
}
template <class T>
inline Complex<T> exp(const Complex<T>& a)
{
    return of_polar(T(numbers::exp(a.re)), a.im);
}
template <class T>
inline Complex<T> ln(const Complex<T>& a)
{
    return {numbers::log(numbers::hypot(a.re, a.im)), numbers::atan2(a.im, a.re)};
}
template <class T>
inline Complex<T> sqrt(const Complex<T>& a)
{
    return of_polar(T(lanes::root_of(numbers::hypot(a.re, a.im))), T(T(0.5) * numbers::atan2(a.im, a.re)));
}
template <class T>
inline Complex<T> sin(const Complex<T>& a)
{
    const auto turn = numbers::sine_and_cosine(a.re), growth = numbers::hyperbolic(a.im);
    return {turn.sine * growth.cosine, turn.cosine * growth.sine};
}
template <class T>
inline Complex<T> cos(const Complex<T>& a)
{
    const auto turn = numbers::sine_and_cosine(a.re), growth = numbers::hyperbolic(a.im);
    return {turn.cosine * growth.cosine, lanes::negated(turn.sine) * growth.sine};
}
template <class T>
inline Complex<T> sinh(const Complex<T>& a)
{
    const auto growth = numbers::hyperbolic(a.re), turn = numbers::sine_and_cosine(a.im);
    return {growth.sine * turn.cosine, growth.cosine * turn.sine};
}
template <class T>
inline Complex<T> cosh(const Complex<T>& a)
{
    const auto growth = numbers::hyperbolic(a.re), turn = numbers::sine_and_cosine(a.im);
    return {growth.cosine * turn.cosine, growth.sine * turn.sine};
}

template <class T>
inline Complex<T> power(const Complex<T>& a, const glm::dvec2& exponent)
{
    constexpr double kLeastExponent = -690.0;  // e to it is taken for 0
    const T zero(0.0);
    const Complex<T> e = Complex<T>{T(exponent.x), T(exponent.y)} * ln(a), out = exp(e);
    const auto none = ((a.re == zero) & (a.im == zero)) | (e.re < T(kLeastExponent));
    return {lanes::choose(none, zero, out.re), lanes::choose(none, zero, out.im)};
}

template <class T>
inline Complex<T> value(JuliaTerms::Function f, const Complex<T>& v, const glm::dvec2& exponent)
{
    using F = JuliaTerms::Function;
    const Complex<T> one{T(1.0), T(0.0)};
    const T half(0.5);
    switch (f) {
    case F::Exp: return exp(v);
    case F::Ln: return ln(v);
    case F::Sin: return sin(v);
    case F::Asin: {
        const Complex<T> l = ln(times_i(v) + sqrt(one - v * v));
        return {l.im, lanes::negated(l.re)};
    }
    case F::Cos: return cos(v);
    case F::Acos: {
        const Complex<T> l = ln(v + sqrt(v * v - one));
        return {l.im, lanes::negated(l.re)};
    }
    case F::Tan: return sin(v) / cos(v);
    case F::Atan: {
        const Complex<T> l = ln((one - times_i(v)) / (one + times_i(v)));
        return {lanes::negated(half) * l.im, half * l.re};
    }
    case F::Sinh: return sinh(v);
    case F::Asinh: return ln(v + sqrt(v * v + one));
    case F::Cosh: return cosh(v);
    case F::Acosh: return ln(v + sqrt(v * v - one));
    case F::Tanh: return sinh(v) / cosh(v);
    case F::Atanh: {
        const Complex<T> l = ln((one + v) / (one - v));
        return {half * l.re, half * l.im};
    }
    default: return power(v, exponent);
    }
}

/// |q|^2, added up in POV-Ray's order: the last bit decides whether a ray that comes in on the set finds it there.
/// Squares of hypercomplex numbers have an order of their own (spec 5b, 12.2).
template <bool Squares = false>
inline auto norm(const auto& q)
{
    if constexpr (Squares) return q.y * q.y + q.z * q.z + q.x * q.x + q.w * q.w;
    else return q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
}

/// The hypercomplex product, which commutes.
inline glm::dvec4 product(const glm::dvec4& a, const glm::dvec4& b)
{
    return {a.x * b.x - a.y * b.y - a.z * b.z + a.w * b.w, a.y * b.x + a.x * b.y - a.w * b.z - a.z * b.w,
            a.z * b.x - a.w * b.y + a.x * b.z - a.y * b.w, a.w * b.x + a.z * b.y + a.y * b.z + a.x * b.w};
}

/// 1/q; q itself where there is none.
inline glm::dvec4 reciprocal(const glm::dvec4& q)
{
    const double a = q.x - q.w, b = q.y + q.z, c = q.x + q.w, d = q.y - q.z;
    const double determinant = (a * a + b * b) * (c * c + d * d);
    if (determinant == 0.0) return q;
    const double m = glm::dot(q, q), k = 2.0 * (q.x * q.w - q.y * q.z);
    return glm::dvec4(q.x * m - q.w * k, -q.y * m - q.z * k, -q.z * m - q.y * k, q.w * m - q.x * k) / determinant;
}

template <class Four>
inline Four by_parts(JuliaTerms::Function f, const Four& q, const glm::dvec2& exponent)
{
    using T = std::decay_t<decltype(q.x)>;
    const Complex<T> a = value<T>(f, {q.x - q.w, q.y + q.z}, exponent),
                     b = value<T>(f, {q.x + q.w, q.y - q.z}, exponent);
    const T half(0.5);
    return Four{half * (a.re + b.re), half * (a.im + b.im), half * (a.im - b.im), half * (b.re - a.re)};
}

inline glm::dvec4 cube(const glm::dvec4& q)
{
    const double n = q.y * q.y + q.z * q.z + q.w * q.w, x2 = q.x * q.x, other = 3.0 * x2 - n;
    return {q.x * (x2 - 3.0 * n), q.y * other, q.z * other, q.w * other};
}

inline glm::dvec4 square(const glm::dvec4& q)
{
    return {q.x * q.x - q.y * q.y - q.z * q.z - q.w * q.w, 2.0 * q.x * q.y, 2.0 * q.x * q.z, 2.0 * q.x * q.w};
}

/// f(q). POV-Ray's hypercomplex cube is its square.
inline glm::dvec4 apply(const JuliaTerms& terms, const glm::dvec4& q)
{
    using F = JuliaTerms::Function;
    switch (terms.function) {
    case F::Square: return square(q);
    case F::Cube: return cube(q);
    case F::HyperSquare:
    case F::HyperCube: return product(q, q);
    case F::Reciprocal: return reciprocal(q);
    default: return by_parts(terms.function, q, terms.exponent);
    }
}

/// What the slope of an orbit is multiplied by at q with f(q) = next: the derivative of powers, for functions their
/// value, which is POV-Ray's way.
inline glm::dvec4 rate(const JuliaTerms& terms, const glm::dvec4& q, const glm::dvec4& next)
{
    using F = JuliaTerms::Function;
    if (terms.function == F::HyperSquare || terms.function == F::HyperCube) return q;
    if (terms.function != F::Reciprocal) return next;
    const glm::dvec4 r = reciprocal(q);
    return -product(r, r);
}

}  // namespace csg::julia
