#pragma once

#include "function/internal/internal_polynomials.h"
#include "numbers/functions/functions.h"

/// Plane curves that are revolved about y or drawn out along z (spec 5b, 16: the SOR switch).
namespace function {

inline bool is_curve(std::uint32_t n)
{
    return n <= 3 || n == 15 || n == 21 || n == 34 || n == 39 || n == 50 || n == 67 || n == 75;
}

struct CurvePoint {
    double x, y;
};

/// q: switch, distance from the axis, angle in degrees.
inline CurvePoint on_curve(const double* a, const double* q)
{
    if (q[0] <= 0.0) return {a[0], a[1]};
    const double rho = std::sqrt(a[0] * a[0] + a[2] * a[2]) - q[1];
    if (q[2] == 0.0) return {rho, a[1]};
    const double angle = q[2] * std::numbers::pi / 180.0, c = numbers::cos(angle), s = numbers::sin(angle);
    return {rho * c - a[1] * s, rho * s + a[1] * c};
}

inline double curve(std::uint32_t n, const double* a)
{
    const double* p = a + 3;
    const std::size_t at = n <= 3 ? 2 : n == 50 || n == 67 ? 4 : 3;
    const auto [x, y] = on_curve(a, p + at);
    const double x2 = x * x, y2 = y * y;
    const auto limited = [p](double v) { return std::min(p[1], std::max(-p[1], v)); };
    switch (n) {
    case 0: return limited(p[0] * (x2 * std::abs(x) - x2 + y2));
    case 1: return limited(-p[0] * (2.0 * x2 * x2 - 3.0 * x2 * y + y2 - 2.0 * y2 * y + y2 * y2));
    case 2: return limited(-p[0] * (x2 * x2 + x2 * y2 - 2.0 * x2 * y - x * y2 + y2));
    case 3: return limited(-p[0] * (squared(x2 + y2) + 3.0 * x2 * y - y2 * y));
    case 15: return field_limit(-p[0] * (x2 * (x2 - p[1] * p[1]) - y2 * (y2 - p[2] * p[2])));
    case 21: return field_limit(-p[0] * (y2 * (1.0 + (p[2] - 4.0 * p[1]) * x) + x2 * (1.0 + p[2])));
    case 34: return field_limit(-p[0] * (y2 - p[2] * p[2] * x2 * x2 + p[1] * p[2] * p[2] * p[2] * x2));
    case 39: return field_limit(-p[0] * (y2 - p[1] * p[1] * p[2] * p[2] * x2 + p[2] * p[2] * x2 * x2));
    case 50: return field_limit(-p[0] * (y2 - p[1] * p[3] * p[3] * x2 * x - p[2] * p[3] * p[3] * x2 * x2));
    case 67: return field_limit(-p[0] * ((p[2] - x) * y2 - p[3] * p[3] * p[1] * x2 - p[3] * p[3] * x2 * x));
    default: return field_limit(-p[0] * (p[1] * p[1] * y + x2 * y - p[2]));  // 75
    }
}

}  // namespace function
