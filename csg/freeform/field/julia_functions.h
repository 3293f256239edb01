#pragma once

#include "csg/freeform/field/julia.h"
#include "numbers/functions/functions.h"

#include <cmath>

/// f of q -> f(q) + constant, in four dimensions (spec 5b, 12.1).
namespace csg::julia {

/// Complex numbers without the checks for what is no number.
struct Complex {
    double re = 0.0, im = 0.0;
};
inline Complex operator+(Complex a, Complex b) { return {a.re + b.re, a.im + b.im}; }
inline Complex operator-(Complex a, Complex b) { return {a.re - b.re, a.im - b.im}; }
inline Complex operator*(Complex a, Complex b) { return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re}; }
inline Complex operator/(Complex a, Complex b)
{
    const double n = b.re * b.re + b.im * b.im;
    return {(a.re * b.re + a.im * b.im) / n, (a.im * b.re - a.re * b.im) / n};
}
inline Complex times_i(Complex a) { return {-a.im, a.re}; }
inline Complex exp(Complex a)
{
    const double size = numbers::exp(a.re);
    return {size * numbers::cos(a.im), size * numbers::sin(a.im)};
}
inline Complex ln(Complex a) { return {numbers::log(numbers::hypot(a.re, a.im)), numbers::atan2(a.im, a.re)}; }
inline Complex sqrt(Complex a)
{
    const double size = std::sqrt(numbers::hypot(a.re, a.im)), half = 0.5 * numbers::atan2(a.im, a.re);
    return {size * numbers::cos(half), size * numbers::sin(half)};
}
inline Complex sin(Complex a)
{
    return {numbers::sin(a.re) * numbers::cosh(a.im), numbers::cos(a.re) * numbers::sinh(a.im)};
}
inline Complex cos(Complex a)
{
    return {numbers::cos(a.re) * numbers::cosh(a.im), -numbers::sin(a.re) * numbers::sinh(a.im)};
}
inline Complex sinh(Complex a)
{
    return {numbers::sinh(a.re) * numbers::cos(a.im), numbers::cosh(a.re) * numbers::sin(a.im)};
}
inline Complex cosh(Complex a)
{
    return {numbers::cosh(a.re) * numbers::cos(a.im), numbers::sinh(a.re) * numbers::sin(a.im)};
}

inline Complex power(Complex a, const glm::dvec2& exponent)
{
    constexpr double kLeastExponent = -690.0;  // e to it is taken for 0
    if (a.re == 0.0 && a.im == 0.0) return {};
    const Complex e = Complex{exponent.x, exponent.y} * ln(a);
    return e.re < kLeastExponent ? Complex{} : exp(e);
}

inline Complex value(JuliaTerms::Function f, Complex v, const glm::dvec2& exponent)
{
    using F = JuliaTerms::Function;
    const Complex one{1.0, 0.0};
    switch (f) {
    case F::Exp: return exp(v);
    case F::Ln: return ln(v);
    case F::Sin: return sin(v);
    case F::Asin: {
        const Complex l = ln(times_i(v) + sqrt(one - v * v));
        return {l.im, -l.re};
    }
    case F::Cos: return cos(v);
    case F::Acos: {
        const Complex l = ln(v + sqrt(v * v - one));
        return {l.im, -l.re};
    }
    case F::Tan: return sin(v) / cos(v);
    case F::Atan: {
        const Complex l = ln((one - times_i(v)) / (one + times_i(v)));
        return {-0.5 * l.im, 0.5 * l.re};
    }
    case F::Sinh: return sinh(v);
    case F::Asinh: return ln(v + sqrt(v * v + one));
    case F::Cosh: return cosh(v);
    case F::Acosh: return ln(v + sqrt(v * v - one));
    case F::Tanh: return sinh(v) / cosh(v);
    case F::Atanh: {
        const Complex l = ln((one + v) / (one - v));
        return {0.5 * l.re, 0.5 * l.im};
    }
    default: return power(v, exponent);
    }
}

/// |q|^2, added up in POV-Ray's order: the last bit decides whether a ray that comes in on the set finds it there.
inline double norm(const glm::dvec4& q) { return q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w; }

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

inline glm::dvec4 by_parts(JuliaTerms::Function f, const glm::dvec4& q, const glm::dvec2& exponent)
{
    const Complex a = value(f, {q.x - q.w, q.y + q.z}, exponent), b = value(f, {q.x + q.w, q.y - q.z}, exponent);
    return 0.5 * glm::dvec4(a.re + b.re, a.im + b.im, a.im - b.im, b.re - a.re);
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
