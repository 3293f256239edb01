#pragma once

#include "csg/freeform/field/julia_functions.h"

#include <algorithm>
#include <cmath>

/// Orbits of all points of a short part of a line at once, for the functions that are polynomials: what is told of a
/// part holds for every point of it, where steps of a march pass over what is thin.
namespace csg::julia {

/// a + b s + c s^2 for s from -1 to 1, and how far the orbit and its derivative by s may be from that and from its
/// derivative (a Taylor model of order two). The coefficients are exact but for rounding.
struct OrbitPart {
    glm::dvec4 a{0.0}, b{0.0}, c{0.0};
    double rest = 0.0, rest_of_rate = 0.0;
};

/// Powers of one quaternion commute, so half of p q + q p is their product, though not that of the coefficients.
struct QuaternionAlgebra {
    static constexpr double kGrowth = 1.0;  ///< |p q| <= this |p| |q|
    static glm::dvec4 product(const glm::dvec4& p, const glm::dvec4& q)
    {
        return {p.x * q.x - p.y * q.y - p.z * q.z - p.w * q.w, p.x * q.y + p.y * q.x, p.x * q.z + p.z * q.x,
                p.x * q.w + p.w * q.x};
    }
};

struct HypercomplexAlgebra {
    static constexpr double kGrowth = 1.4142135623730951;
    static glm::dvec4 product(const glm::dvec4& p, const glm::dvec4& q) { return julia::product(p, q); }
};

inline double size_of(const glm::dvec4& q) { return std::sqrt(norm(q)); }

template <class Algebra>
OrbitPart product(const OrbitPart& p, const OrbitPart& q)
{
    const auto times = [](const glm::dvec4& u, const glm::dvec4& v) { return Algebra::product(u, v); };
    OrbitPart out;
    out.a = times(p.a, q.a);
    out.b = times(p.a, q.b) + times(p.b, q.a);
    out.c = times(p.a, q.c) + times(p.b, q.b) + times(p.c, q.a);
    const double cubic = size_of(times(p.b, q.c) + times(p.c, q.b)), quartic = size_of(times(p.c, q.c));
    const double pb = size_of(p.b), pc = size_of(p.c), qb = size_of(q.b), qc = size_of(q.c);
    const double most_p = size_of(p.a) + pb + pc, most_q = size_of(q.a) + qb + qc;
    const double rate_p = pb + 2.0 * pc, rate_q = qb + 2.0 * qc;
    out.rest = cubic + quartic + Algebra::kGrowth * (most_p * q.rest + most_q * p.rest + p.rest * q.rest);
    out.rest_of_rate = 3.0 * cubic + 4.0 * quartic +
                       Algebra::kGrowth * ((most_p + p.rest) * q.rest_of_rate + (most_q + q.rest) * p.rest_of_rate +
                                           p.rest * rate_q + q.rest * rate_p);
    return out;
}

/// f of all points of the part.
inline OrbitPart apply(JuliaTerms::Function f, const OrbitPart& q)
{
    using F = JuliaTerms::Function;
    switch (f) {
    case F::Square: return product<QuaternionAlgebra>(q, q);
    case F::Cube: return product<QuaternionAlgebra>(product<QuaternionAlgebra>(q, q), q);
    default: return product<HypercomplexAlgebra>(q, q);
    }
}

/// What the squares of the sizes of a part's points are.
struct SizeRange {
    double low, high;
    bool one_way;  ///< they only grow along the part, or only fall

    explicit SizeRange(const OrbitPart& q)
    {
        const double c1 = 2.0 * glm::dot(q.a, q.b), c2 = glm::dot(q.b, q.b) + 2.0 * glm::dot(q.a, q.c),
                     c3 = 2.0 * glm::dot(q.b, q.c), c4 = glm::dot(q.c, q.c), first = norm(q.a);
        const double b = size_of(q.b), c = size_of(q.c), most = size_of(q.a) + b + c;
        const double off = (2.0 * most + q.rest) * q.rest, odd = std::abs(c1) + std::abs(c3) + off;
        low = first + std::min(c2, 0.0) - odd;
        high = first + std::max(c2, 0.0) + c4 + odd;
        const double off_rate = 2.0 * ((most + q.rest) * q.rest_of_rate + q.rest * (b + 2.0 * c));
        one_way = std::abs(c1) > 2.0 * std::abs(c2) + 3.0 * std::abs(c3) + 4.0 * c4 + off_rate;
    }
};

}  // namespace csg::julia
