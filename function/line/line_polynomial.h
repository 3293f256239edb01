#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>

/// Numbers of a calculation whose arguments move along a line: polynomials of how far they have come. Sums, products
/// and whole powers of polynomials are polynomials; what else a function does with them makes them `none`.
namespace function {

struct LinePolynomial {
    static constexpr int kMost = 7;  ///< greater degrees are not followed: coefficients fill a vector register
    static constexpr int kNone = -1;

    alignas(64) double c[kMost + 1];  ///< coefficients, the constant first, and 0 from `degree` on
    int degree;                       ///< kNone: not a polynomial
    bool cut;                         ///< what is meant is this cut off at +-10
    double size;   ///< of the absolute values of all terms that were added up, for places from 0 to 1
    double error;  ///< at most what values there are off by, from how the coefficients were rounded

    LinePolynomial() = default;
    LinePolynomial(double v)  // implicit: constants of formulas
        : c{v}, degree(0), cut(false), size(std::abs(v)), error(0.0)
    {}
    /// from + s * way, `from` being off by up to `room`.
    LinePolynomial(double from, double way, double room)
        : c{from, way}, degree(way == 0.0 ? 0 : 1), cut(false), size(std::abs(from) + std::abs(way)), error(room)
    {}
    static LinePolynomial none()
    {
        LinePolynomial out(0.0);
        out.degree = kNone;
        return out;
    }

    /// Whether it may be calculated with.
    bool known() const { return degree != kNone && !cut; }
    bool constant() const { return known() && degree == 0; }
};

namespace detail {

inline constexpr double kUnit = 0x1p-52;

/// A register's worth of coefficients, which g++ and clang++ know to move by a place without memory in between.
typedef double Eightfold __attribute__((vector_size(sizeof(double) * (LinePolynomial::kMost + 1))));

/// a + factor b, factor 1 or -1.
inline LinePolynomial line_sum(const LinePolynomial& a, const LinePolynomial& b, double factor)
{
    if (!a.known() || !b.known()) return LinePolynomial::none();
    LinePolynomial out;
    out.degree = std::max(a.degree, b.degree);
    out.cut = false;
    for (int i = 0; i <= LinePolynomial::kMost; ++i) out.c[i] = a.c[i] + factor * b.c[i];
    out.size = a.size + b.size;
    out.error = a.error + b.error + kUnit * out.size;
    return out;
}

}  // namespace detail

inline LinePolynomial operator+(const LinePolynomial& a, const LinePolynomial& b)
{
    return detail::line_sum(a, b, 1.0);
}
inline LinePolynomial operator-(const LinePolynomial& a, const LinePolynomial& b)
{
    return detail::line_sum(a, b, -1.0);
}
inline LinePolynomial operator*(const LinePolynomial& a, const LinePolynomial& b)
{
    if (!a.known() || !b.known() || a.degree + b.degree > LinePolynomial::kMost) return LinePolynomial::none();
    const LinePolynomial &few = a.degree < b.degree ? a : b, &many = a.degree < b.degree ? b : a;
    using detail::Eightfold;
    Eightfold by, sum = {};
    std::memcpy(&by, many.c, sizeof by);
    // Horner's rule: times s moves each coefficient to the next place.
    for (int i = few.degree; i >= 0; --i)
        sum = __builtin_shufflevector(sum, Eightfold{}, 8, 0, 1, 2, 3, 4, 5, 6) + few.c[i] * by;
    LinePolynomial out;
    out.degree = a.degree + b.degree;
    out.cut = false;
    std::memcpy(out.c, &sum, sizeof sum);
    out.size = a.size * b.size;
    out.error = a.error * (b.size + b.error) + a.size * b.error + (few.degree + 2) * detail::kUnit * out.size;
    return out;
}
inline LinePolynomial squared(const LinePolynomial& a) { return a * a; }

/// a^exponent of a whole exponent that is not negative, none for others.
inline LinePolynomial power(const LinePolynomial& a, const LinePolynomial& exponent)
{
    if (!exponent.constant() || !(exponent.c[0] >= 0.0) || exponent.c[0] > LinePolynomial::kMost ||
        exponent.c[0] != std::floor(exponent.c[0]))
        return LinePolynomial::none();
    LinePolynomial out(1.0);
    for (int i = 0; i < static_cast<int>(exponent.c[0]); ++i) out = out * a;
    return out;
}

}  // namespace function
