#include "csg/solids/shared/polynomial_shape.h"

#include "csg/solids/shared/polynomial_box.h"
#include "csg/solids/shared/polynomial_row.h"

#include <stdexcept>

namespace csg {

PolynomialShape::PolynomialShape(int degree, std::vector<double> coefficients)
    : degree_(degree), coefficients_(std::move(coefficients))
{
    if (degree < 1 || degree > kMostDegree ||
        coefficients_.size() != static_cast<std::size_t>((degree + 1) * (degree + 2) * (degree + 3) / 6))
        throw std::invalid_argument("a polynomial with the wrong number of coefficients");
    std::size_t next = 0;
    for (int i = degree; i >= 0 && degree > kLow; --i)
        for (int j = degree - i; j >= 0; --j)
            for (int k = degree - i - j; k >= 0; --k, ++next)
                if (const double c = coefficients_[next]; c != 0.0)
                    terms_.push_back(
                        {c, static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j), static_cast<std::uint8_t>(k)});
    next = 0;
    for (int i = degree; i >= 0; --i)
        for (int j = degree - i; j >= 0; --j) {
            leading_size_ += std::abs(coefficients_[next]);  // of x^i y^j z^(degree - i - j)
            next += static_cast<std::size_t>(degree - i - j + 1);
        }
    box_ = polynomial_box(degree_, coefficients_);
    boxed_ = box_.finite();
}

template <class F>
void PolynomialShape::sum_any(const glm::dvec3& o, const glm::dvec3& d, Along& out, F&& of) const
{
    const auto with_row = [&]<int blocks>() {
        PolynomialRow<blocks> sum;
        sum_along({{o.x, o.y, o.z}, {d.x, d.y, d.z}}, sum, of);
        sum.store(out.data(), degree_ + 1);
    };
    if (degree_ < 8) with_row.template operator()<1>();
    else if (degree_ < 16) with_row.template operator()<2>();
    else with_row.template operator()<5>();
}

void PolynomialShape::along_any(const glm::dvec3& o, const glm::dvec3& d, Along& out) const
{
    sum_any(o, d, out, [](double v) { return v; });
}

void PolynomialShape::sizes_along(const glm::dvec3& o, const glm::dvec3& d, Along& out) const
{
    sum_any(o, d, out, [](double v) { return std::abs(v); });
}

double PolynomialShape::nearer(const glm::dvec3& o, const glm::dvec3& d, double t) const
{
    constexpr double kMost = 1e-6;  // a longer step is none of rounding
    const glm::dvec3 p = o + t * d;
    double power[3][kMostDegree + 2];  // power[axis][n + 1] = p^n; p^-1 is never used but with a factor of 0
    for (int axis = 0; axis < 3; ++axis) {
        power[axis][0] = 0.0;
        power[axis][1] = 1.0;
        for (int n = 1; n <= degree_; ++n) power[axis][n + 1] = power[axis][n] * p[axis];
    }
    double value = 0.0, slope = 0.0;
    for (const Term& term : terms_) {
        const double *x = power[0] + term.i, *y = power[1] + term.j, *z = power[2] + term.k;
        value += term.c * x[1] * y[1] * z[1];
        slope += term.c * (term.i * x[0] * y[1] * z[1] * d.x + term.j * x[1] * y[0] * z[1] * d.y +
                           term.k * x[1] * y[1] * z[0] * d.z);
    }
    const double step = value / slope;
    return std::abs(step) < kMost * (1.0 + std::abs(t)) ? t - step : t;
}

int PolynomialShape::sure_degree(const glm::dvec3& o, const glm::dvec3& d, const Along& c) const
{
    // The same sums with every term positive.
    Along size{};
    sizes_along(glm::abs(o), glm::abs(d), size);
    int degree = degree_;
    while (degree > 0 && !(std::abs(c[at(degree)]) > rounding() * size[at(degree)])) --degree;
    return degree;
}

double PolynomialShape::value(const glm::dvec3& p) const
{
    const double* next = coefficients_.data();
    double in_x = 0.0;
    for (int i = degree_; i >= 0; --i) {
        double in_y = 0.0;
        for (int j = degree_ - i; j >= 0; --j) {
            double in_z = 0.0;
            for (int k = degree_ - i - j; k >= 0; --k) in_z = in_z * p.z + *next++;
            in_y = in_y * p.y + in_z;
        }
        in_x = in_x * p.x + in_y;
    }
    return in_x;
}

glm::dvec3 PolynomialShape::gradient(const glm::dvec3& p) const
{
    const double* next = coefficients_.data();
    glm::dvec3 in_x(0.0);
    double value_x = 0.0;
    for (int i = degree_; i >= 0; --i) {
        double value_y = 0.0, slope_y = 0.0, slope_yz = 0.0;
        for (int j = degree_ - i; j >= 0; --j) {
            double value_z = 0.0, slope_z = 0.0;
            for (int k = degree_ - i - j; k >= 0; --k) {
                slope_z = slope_z * p.z + value_z;
                value_z = value_z * p.z + *next++;
            }
            slope_y = slope_y * p.y + value_y;
            value_y = value_y * p.y + value_z;
            slope_yz = slope_yz * p.y + slope_z;
        }
        in_x.x = in_x.x * p.x + value_x;
        value_x = value_x * p.x + value_y;
        in_x.y = in_x.y * p.x + slope_y;
        in_x.z = in_x.z * p.x + slope_yz;
    }
    return in_x;
}

}  // namespace csg
