#pragma once

#include "csg/polynomial_along.h"
#include "csg/types.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace csg {

/// A polynomial of x, y and z up to degree 35; immutable, shared by all instances.
class PolynomialShape {
public:
    static constexpr int kMostDegree = 35;
    using Along = std::array<double, kMostDegree + 1>;   ///< coefficients of powers of t, lowest first

    /// Coefficients in POV-Ray's order: powers of x falling, then of y, then of z (spec 5a, 5.9).
    PolynomialShape(int degree, std::vector<double> coefficients);

    int degree() const { return degree_; }
    const std::vector<double>& coefficients() const { return coefficients_; }
    double value(const glm::dvec3& p) const;
    glm::dvec3 gradient(const glm::dvec3& p) const;

    /// The polynomial along o + t d.
    void along(const glm::dvec3& o, const glm::dvec3& d, Along& out) const
    {
        switch (degree_) {
        case 2: return along_of<2>(o, d, out);
        case 3: return along_of<3>(o, d, out);
        case 4: return along_of<4>(o, d, out);
        default: return along_any(o, d, out);
        }
    }

private:
    template <int degree>
    void along_of(const glm::dvec3& o, const glm::dvec3& d, Along& out) const
    {
        const double* next = coefficients_.data();
        const detail::Powers<degree> found = detail::along_x<degree>(next, {o.x, o.y, o.z, d.x, d.y, d.z});
        std::copy(found.begin(), found.end(), out.begin());
    }
    void along_any(const glm::dvec3& o, const glm::dvec3& d, Along& out) const
    {
        // Horner's scheme in x, whose coefficients are polynomials of y and z, and so on; numbers here are polynomials of t.
        const double* next = coefficients_.data();
        std::fill_n(out.begin(), degree_ + 1, 0.0);
        for (int i = degree_; i >= 0; --i) {
            Along in_y;
            std::fill_n(in_y.begin(), degree_ - i + 1, 0.0);
            for (int j = degree_ - i; j >= 0; --j) {
                Along in_z;
                std::fill_n(in_z.begin(), degree_ - i - j + 1, 0.0);
                for (int k = degree_ - i - j; k >= 0; --k) step(in_z, degree_ - i - j - k, o.z, d.z, *next++);
                step(in_y, degree_ - i - j, o.y, d.y, in_z);
            }
            step(out, degree_ - i, o.x, d.x, in_y);
        }
    }
    /// p (of degree `degree` - 1) times (o + t d), plus a number or a polynomial no longer than the product.
    static void step(Along& p, int degree, double o, double d, double plus)
    {
        for (int i = degree; i > 0; --i) p[at(i)] = p[at(i)] * o + p[at(i - 1)] * d;
        p[0] = p[0] * o + plus;
    }
    static void step(Along& p, int degree, double o, double d, const Along& plus)
    {
        step(p, degree, o, d, 0.0);
        for (int i = 0; i <= degree; ++i) p[at(i)] += plus[at(i)];
    }
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    int degree_;
    std::vector<double> coefficients_;
};

/// Where c[0] + c[1] t + ... + c[degree] t^degree changes its sign, in order: at most `degree` places. c[degree] is not 0.
inline int sign_changes(const PolynomialShape::Along& c, int degree, double (&out)[PolynomialShape::kMostDegree]);

}  // namespace csg

#include "csg/polynomial_roots.h"
