#pragma once

#include "csg/solids/shared/polynomial_along.h"
#include "csg/solids/shared/polynomial_between.h"
#include "numbers/polynomial_roots.h"
#include "csg/base/types.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace csg {

/// A polynomial of x, y and z up to degree 35; immutable, shared by all instances.
class PolynomialShape {
public:
    static constexpr int kMostDegree = kMostPolynomialDegree;
    using Along = PolynomialCoefficients;

    /// Coefficients in POV-Ray's order: powers of x falling, then of y, then of z (spec 5a, 5.9).
    PolynomialShape(int degree, std::vector<double> coefficients);

    int degree() const { return degree_; }
    bool has_highest_powers() const { return leading_size_ > 0.0; }
    const std::vector<double>& coefficients() const { return coefficients_; }
    /// Of where it is not positive; everything where that has no end or nothing is known.
    const Aabb& box() const { return box_; }
    double value(const glm::dvec3& p) const;
    glm::dvec3 gradient(const glm::dvec3& p) const;

    /// The polynomial along o + t d, where |d| = 1.
    void along(const glm::dvec3& o, const glm::dvec3& d, Along& out) const
    {
        switch (degree_) {
        case 2: return along_of<2>(o, d, out);
        case 3: return along_of<3>(o, d, out);
        case 4: return along_of<4>(o, d, out);
        default: return along_any(o, d, out);
        }
    }

    /// Of a quartic, of a ray or of a ray a lane: along() from the lowest power up.
    template <class V>
    detail::Powers<4, V> quartic_along(const detail::Course<V>& ray) const
    {
        const double* next = coefficients_.data();
        return detail::along<0, 4>(next, ray);
    }

    /// Of degrees above 4, of a ray or of a ray a lane, from the lowest power up; out begins as 0.
    template <class Row>
    void sum_along(const detail::Course<typename Row::Number>& ray, Row& out) const
    {
        sum_along(ray, out, [](double coefficient) { return coefficient; });
    }

    /// Cuts lo to hi down to where o + t d is in the box; hi is not above lo where it never is.
    template <class V>
    void clip(const detail::Course<V>& ray, V& lo, V& hi) const
    {
        if (!boxed_) return;
        for (int axis = 0; axis < 3; ++axis) {
            const V a = (V(box_.lower[axis]) - ray.o[axis]) / ray.d[axis],
                    b = (V(box_.upper[axis]) - ray.o[axis]) / ray.d[axis];
            // Of no number the one before remains.
            lo = lanes::larger(lo, lanes::smaller(a, b));
            hi = lanes::smaller(hi, lanes::larger(a, b));
        }
    }

    /// Cuts lo to hi down to where along()'s c may have roots, where clip() did not.
    template <class V>
    void bound(const V* c, int degree, V& lo, V& hi) const
    {
        if (boxed_) return;
        const V most = detail::root_bound(c, degree);
        lo = lanes::larger(lo, lanes::negated(most));
        hi = lanes::smaller(hi, most);
    }

    /// sign_changes() of along()'s, whose degree is degree_along()'s: those between lo and hi at least, of
    /// those above `enough` the first.
    int changes(const Along& c, int degree, double lo, double hi, double enough, double (&out)[kMostDegree]) const
    {
        if (degree <= 0) return 0;
        if (degree > kLow) {
            bound(c.data(), degree, lo, hi);
            if (const int count = sign_changes_between(c, degree, lo, hi, enough, out); count != kUnsureChanges)
                return count;
        }
        return sign_changes(c, degree, out);
    }

    /// A root of along()'s, one step of Newton's nearer: asked at the point itself, where no powers of t cancel each
    /// other. Such coefficients of degree 35 leave 1e-10, the point 1e-15. Low degrees lose too little to be worth it.
    double polished(const glm::dvec3& o, const glm::dvec3& d, double t) const
    {
        return degree_ > kLow ? nearer(o, d, t) : t;
    }

    /// Whether the coefficient of the highest power is surely more than rounding.
    template <class V>
    lanes::Truth<V> has_degree(const V& last) const
    {
        return lanes::size_of(last) > V(rounding() * leading_size_);
    }

    /// What is left of the degree where leading coefficients found by along() are nothing but rounding: such a one
    /// would put a root anywhere.
    int degree_along(const glm::dvec3& o, const glm::dvec3& d, const Along& c) const
    {
        return has_degree(c[at(degree_)]) ? degree_ : sure_degree(o, d, c);
    }

private:
    /// Above what rounding adds to a coefficient, in parts of the sum of its terms' sizes: some 4 roundings a power.
    double rounding() const { return 4 * degree_ * 0x1p-53; }

    /// c x^i y^j z^k
    struct Term {
        double c;
        std::uint8_t i, j, k;
    };
    static constexpr int kLow = 4;

    double nearer(const glm::dvec3& o, const glm::dvec3& d, double t) const;
    int sure_degree(const glm::dvec3& o, const glm::dvec3& d, const Along& c) const;

    template <int degree>
    void along_of(const glm::dvec3& o, const glm::dvec3& d, Along& out) const
    {
        const double* next = coefficients_.data();
        const detail::Course<double> ray{{o.x, o.y, o.z}, {d.x, d.y, d.z}};
        const detail::Powers<degree, double> found = detail::along<0, degree>(next, ray);
        std::copy(found.begin(), found.end(), out.begin());
    }
    void along_any(const glm::dvec3& o, const glm::dvec3& d, Along& out) const;
    void sizes_along(const glm::dvec3& o, const glm::dvec3& d, Along& out) const;
    template <class F>
    void sum_any(const glm::dvec3& o, const glm::dvec3& d, Along& out, F&& of) const;
    /// The terms' sum with `of` each coefficient: Horner's scheme in x, whose coefficients are polynomials of y and z,
    /// and so on; numbers here are polynomials of t. Most high degrees have few terms: what is between them costs
    /// nothing but its factors.
    template <class Row, class F>
    void sum_along(const detail::Course<typename Row::Number>& ray, Row& in_x, F&& of) const
    {
        Row in_y, in_z;
        const auto raise = [&](Row& row, int axis, int times) {
            for (int n = 0; n < times; ++n) row.times(ray.o[axis], ray.d[axis]);
        };
        for (std::size_t n = 0; n < terms_.size(); ++n) {
            const Term& term = terms_[n];
            const Term next = n + 1 < terms_.size() ? terms_[n + 1] : Term{};
            const bool last = n + 1 == terms_.size(), same_x = !last && next.i == term.i,
                       same_y = same_x && next.j == term.j;
            in_z.add(typename Row::Number(of(term.c)));
            raise(in_z, 2, same_y ? term.k - next.k : term.k);
            if (same_y) continue;
            in_y.add(in_z);
            in_z.clear();
            raise(in_y, 1, same_x ? term.j - next.j : term.j);
            if (same_x) continue;
            in_x.add(in_y);
            in_y.clear();
            raise(in_x, 0, term.i - next.i);
        }
    }
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    int degree_;
    std::vector<double> coefficients_;
    std::vector<Term> terms_;  ///< those that are not 0, above degree kLow
    Aabb box_;
    bool boxed_ = false;         ///< the box is finite
    double leading_size_ = 0.0;  ///< sum of the sizes of the coefficients of the highest degree
};

}  // namespace csg
