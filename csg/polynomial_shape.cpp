#include "csg/polynomial_shape.h"

#include <stdexcept>

namespace csg {

PolynomialShape::PolynomialShape(int degree, std::vector<double> coefficients)
    : degree_(degree), coefficients_(std::move(coefficients))
{
    if (degree < 1 || degree > kMostDegree ||
        coefficients_.size() != static_cast<std::size_t>((degree + 1) * (degree + 2) * (degree + 3) / 6))
        throw std::invalid_argument("a polynomial with the wrong number of coefficients");
    std::size_t next = 0;
    for (int i = degree; i >= 0; --i)
        for (int j = degree - i; j >= 0; --j) {
            leading_size_ += std::abs(coefficients_[next]);   // of x^i y^j z^(degree - i - j)
            next += static_cast<std::size_t>(degree - i - j + 1);
        }
}

int PolynomialShape::sure_degree(const glm::dvec3& o, const glm::dvec3& d, const Along& c) const
{
    // The same sums with every term positive.
    Along size{};
    along_any(glm::abs(o), glm::abs(d), size, [](double v) { return std::abs(v); });
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
