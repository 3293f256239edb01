#pragma once

#include "numbers/polynomial_along.h"
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

    /// A root of along()'s, one step of Newton's nearer: asked at the point itself, where no powers of t cancel each
    /// other. Such coefficients of degree 35 leave 1e-10, the point 1e-15. Low degrees lose too little to be worth it.
    double polished(const glm::dvec3& o, const glm::dvec3& d, double t) const
    {
        return degree_ > kLow ? nearer(o, d, t) : t;
    }

    /// What is left of the degree where leading coefficients found by along() are nothing but rounding: such a one
    /// would put a root anywhere.
    int degree_along(const glm::dvec3& o, const glm::dvec3& d, const Along& c) const
    {
        if (std::abs(c[at(degree_)]) > rounding() * leading_size_) return degree_;
        return sure_degree(o, d, c);
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
        const detail::Powers<degree> found = detail::along<0, degree>(next, {{o.x, o.y, o.z}, {d.x, d.y, d.z}});
        std::copy(found.begin(), found.end(), out.begin());
    }
    void along_any(const glm::dvec3& o, const glm::dvec3& d, Along& out) const
    {
        along_any(o, d, out, [](double v) { return v; });
    }
    /// The polynomial with `of` each coefficient.
    template <class F>
    void along_any(const glm::dvec3& o, const glm::dvec3& d, Along& out, F&& of) const
    {
        // Horner's scheme in x, whose coefficients are polynomials of y and z, and so on; numbers here are polynomials
        // of t. Most high degrees have few terms: what has not begun yet costs nothing.
        const double* next = coefficients_.data();
        Sum in_x;
        for (int i = degree_; i >= 0; --i) {
            Sum in_y;
            for (int j = degree_ - i; j >= 0; --j) {
                Sum in_z;
                for (int k = degree_ - i - j; k >= 0; --k) {
                    const double c = of(*next++);
                    in_z.times(o.z, d.z);
                    if (c != 0.0) in_z.add(&c, 0);
                }
                in_y.times(o.y, d.y);
                in_y.add(in_z.c.data(), in_z.degree);
            }
            in_x.times(o.x, d.x);
            in_x.add(in_y.c.data(), in_y.degree);
        }
        std::fill_n(out.begin(), degree_ + 1, 0.0);
        std::copy_n(in_x.c.begin(), in_x.degree + 1, out.begin());
    }
    /// A polynomial of t; degree -1 for none yet.
    struct Sum {
        Along c;
        int degree = -1;

        void times(double o, double d)
        {
            if (degree < 0) return;
            c[at(degree + 1)] = c[at(degree)] * d;
            for (int i = degree; i > 0; --i) c[at(i)] = c[at(i)] * o + c[at(i - 1)] * d;
            c[0] *= o;
            ++degree;
        }
        void add(const double* other, int other_degree)
        {
            for (; degree < other_degree; ++degree) c[at(degree + 1)] = 0.0;
            for (int i = 0; i <= other_degree; ++i) c[at(i)] += other[i];
        }
    };
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    int degree_;
    std::vector<double> coefficients_;
    std::vector<Term> terms_;  ///< those that are not 0, above degree kLow
    Aabb box_;
    double leading_size_ = 0.0;  ///< sum of the sizes of the coefficients of the highest degree
};

}  // namespace csg
