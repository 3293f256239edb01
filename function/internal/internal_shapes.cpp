#include "function/internal/internal_shapes.h"

#include "csg/freeform/field/rounded_box.h"
#include "function/internal/internal_polynomials.h"
#include "numbers/functions/functions.h"
#include "numbers/remainder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace function {
namespace {

using std::numbers::pi;

/// Remainder in [0, d).
double wrapped(double v, double d)
{
    const double m = numbers::fmod(v, d);
    return m < 0.0 ? m + d : m;
}

/// Distance of (a, b) from the centre of a profile: 1 a circle, 0 a square, else a superellipse.
double profile(double a, double b, double kind)
{
    if (kind == 1.0) return std::sqrt(a * a + b * b);
    if (kind == 0.0) return std::max(std::abs(a), std::abs(b));
    return numbers::pow(numbers::pow(std::abs(a), 2.0 / kind) + numbers::pow(std::abs(b), 2.0 / kind), kind * 0.5);
}

/// The three bells along z, y and x that ellipsoids and spikes are made of.
std::array<double, 3> bells(const double* a)
{
    const double k = a[3], w = a[4];
    const double x2 = a[0] * a[0], y2 = a[1] * a[1], z2 = a[2] * a[2];
    return {numbers::exp(-w * (k * x2 + k * y2 + z2)), numbers::exp(-w * (k * x2 + y2 + k * z2)),
            numbers::exp(-w * (x2 + k * y2 + k * z2))};
}

}  // namespace

double blob(const double* a)
{
    const auto part = [&](double x, double strength, double inverse_radius) {
        const double d = 1.0 - std::min(1.0, inverse_radius * inverse_radius * (x * x + a[1] * a[1] + a[2] * a[2]));
        return strength * d * d;
    };
    return -part(a[0] + a[3] / 2.0, a[4], a[5]) - part(a[0] - a[3] / 2.0, a[6], a[7]);
}

double blob2(const double* a)
{
    const double s = a[1] * a[1] + a[2] * a[2], x = a[0] - a[3];
    return a[6] - a[5] * (numbers::exp(-a[4] * (a[0] * a[0] + s)) + numbers::exp(-a[4] * (x * x + s)));
}

double comma(const double* a)
{
    const double x = a[0] == 0.0 && a[2] == 0.0 ? 1e-4 : a[0], y = a[1], z = a[2], p = a[3];
    const double theta = numbers::atan2(z, x);
    const double r = std::sqrt((x + p / 4.0) * (x + p / 4.0) + z * z);
    const double lower =
        std::min(z, 0.5 * p * numbers::cos(theta / 2.0) - std::sqrt((r - 0.75 * p) * (r - 0.75 * p) + y * y));
    const double head = 0.5 * p - std::sqrt((x - 0.5 * p) * (x - 0.5 * p) + y * y + z * z);
    return -std::max(lower, head);
}

double ellipsoids(std::uint32_t n, const double* a)
{
    const auto [e1, e2, e3] = bells(a);
    const double all = n == 10 ? std::max({e1, e2, e3}) : n == 32 ? std::min({e1, e2, e3}) : e1 + e2 + e3;
    return a[6] - a[5] * all;
}

double ellipsoid(const double* a)
{
    const double x = a[3] * a[0], y = a[4] * a[1], z = a[5] * a[2];
    return std::sqrt(x * x + y * y + z * z);
}

double enneper(const double* a)
{
    const double x2 = a[0] * a[0], y2 = a[1] * a[1], z = std::abs(a[2]) < 0.2 ? 0.2 : a[2];
    const double first = (y2 - x2) / (2.0 * z) + 2.0 * a[2] * a[2] / 9.0, second = (y2 - x2) / (4.0 * z);
    return field_limit(-a[3] * (first * first * first - 6.0 * second * second));
}

double whole_enneper(const double* a)
{
    const double x2 = a[0] * a[0], y2 = a[1] * a[1], z2 = a[2] * a[2], z = std::abs(a[2]) < 0.2 ? 0.2 : a[2];
    const double first = (y2 - x2) / (2.0 * z) + 2.0 * z2 / 9.0 + 2.0 / 3.0;
    const double second = (y2 - x2) / (4.0 * z) - 0.25 * (x2 + y2 + 8.0 * z2 / 9.0) + 2.0 / 9.0;
    return field_limit(-a[3] * (first * first * first - 6.0 * second * second));
}

double helical_torus(const double* a)
{
    const double* p = a + 3;
    const double rho = std::sqrt(a[0] * a[0] + a[2] * a[2]);
    const double phi = numbers::atan2(rho == 0.0 ? 1e-6 : a[0], a[2]);
    const double from_ring = rho - p[0];
    const double tau = numbers::atan2(from_ring, a[1]);
    const double r = std::sqrt(from_ring * from_ring + a[1] * a[1]);
    const double psi = wrapped(phi * p[1] + tau * p[2], 2.0 * pi) - pi;
    const double groove = numbers::atan2(psi * p[8], r - p[5]);
    const double wall = p[3] * numbers::cos(groove * p[7] + phi * p[9]) + p[4];
    const double strand = std::min(std::sqrt((r - p[5]) * (r - p[5]) + p[6] * psi * psi), r + p[5]);
    return -std::max(p[4] + p[5] - p[0] - rho, wall - strand);
}

double helix1(const double* a)
{
    const double* p = a + 3;
    const double rho = std::sqrt(a[0] * a[0] + a[2] * a[2]);
    const double theta = wrapped(p[0] * numbers::atan2(a[2], a[0]) + p[0] * p[1] * a[1], 2.0 * pi);
    double b = (theta - pi) / (p[4] * p[0] * p[1]), d = rho - p[3];
    if (p[5] != 1.0 && p[6] != 0.0) {
        const double angle = p[6] * pi / 180.0, c = numbers::cos(angle), s = numbers::sin(angle);
        std::tie(d, b) = std::pair(d * c - b * s, d * s + b * c);
    }
    return std::min(p[3] + rho, profile(d, b, p[5])) - p[2];
}

double helix2(const double* a)
{
    const double* p = a + 3;
    const double c = numbers::cos(p[1] * a[1]), s = numbers::sin(p[1] * a[1]);
    const double x = a[0] - p[3] * c, z = a[2] - p[3] * s;
    return profile(x * c + z * s, -x * s + z * c, p[5]) - p[2];
}

double hexagonal(bool y, const double* at)
{
    const double half = std::numbers::sqrt3 / 2.0;
    double a = std::abs(numbers::fmod(std::abs(at[0]), 2.0 * half) - half),
           b = std::abs(numbers::fmod(std::abs(at[1]), 3.0) - 1.5);
    if (a * a + b * b > (half - a) * (half - a) + (1.5 - b) * (1.5 - b)) {
        a = half - a;
        b = 1.5 - b;
    }
    if (numbers::atan2(b, a) < pi / 6.0) return y ? b : a;
    return y ? std::abs(-half * a + 0.5 * b) : 0.5 * a + half * b;
}

double mesh1(const double* a)
{
    const double* p = a + 3;
    const auto thread = [&](double offset, double along, double distance) {
        const double up = a[1] + offset, across = std::abs(wrapped(along, 2.0 * distance) - distance) * p[2];
        return std::sqrt(p[4] * p[4] * up * up + across * across);
    };
    const double over = p[3] * numbers::cos(pi * a[2] / p[1]), under = p[3] * numbers::cos(pi * a[0] / p[0]);
    return std::min({thread(-over, a[0], p[0]), thread(over, a[0] - p[0], p[0]), thread(under, a[2], p[1]),
                     thread(-under, a[2] - p[1], p[1])});
}

double poly4(const double* a)
{
    const double y = a[1];
    const double r = a[3] + a[4] * y + a[5] * y * y + a[6] * y * y * y + a[7] * y * y * y * y;
    return std::sqrt(a[0] * a[0] + a[2] * a[2]) - std::max(-5.0, r);
}

double polytubes(const double* a)
{
    const double y = a[1];
    const double r = a[4] + a[5] * y + a[6] * y * y + a[7] * y * y * y + a[8] * y * y * y * y;
    double nearest = 10000.0;
    for (double i = 0.0; i < std::trunc(a[3]); i += 1.0) {
        const double angle = 2.0 * pi * i / a[3], x = a[0] - r * numbers::sin(angle),
                     z = a[2] - r * numbers::cos(angle);
        nearest = std::min(nearest, std::sqrt(x * x + z * z));
    }
    return nearest;
}

double quantum(const double* a)
{
    const double x = a[0] == 0.0 && a[2] == 0.0 ? 1e-6 : a[0];
    const double rho = std::sqrt(x * x + a[2] * a[2]);
    const double c = numbers::cos(numbers::atan2(rho, a[1])), r = 2.0 * std::sqrt(rho * rho + a[1] * a[1]);
    const double t = r * r * numbers::exp(-0.33333333 * r) * (3.0 * c * c - 1.0);
    return -0.1 * (t * t - 12.0);
}

double rounded_box(const double* a)
{
    return csg::RoundedBox{{a[4] - a[3], a[5] - a[3], a[6] - a[3]}, a[3]}({a[0], a[1], a[2]});
}

double spikes(const double* a)
{
    const auto [e1, e2, e3] = bells(a);
    const double s = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
    return a[5] * (e1 + e2 + e3 - a[7] * numbers::exp(-a[6] * s));
}

double spiral(const double* a)
{
    const double* p = a + 3;
    const double x = a[0] == 0.0 && a[2] == 0.0 ? 1e-6 : a[0];
    const double r = std::sqrt(x * x + a[2] * a[2]) + p[0] * numbers::atan2(a[2], x) / (2.0 * pi);
    const double q = profile(numbers::fmod(r, p[0]) - p[0] / 2.0, a[1], p[5]);
    const double far = std::sqrt(x * x + a[1] * a[1] + a[2] * a[2]);
    return -std::min(p[2] - far, p[1] - std::min(q, far));
}

double superellipsoid(const double* a)
{
    const double e = 2.0 / a[3], n = 2.0 / a[4];
    const double round = numbers::pow(numbers::pow(std::abs(a[0]), e) + numbers::pow(std::abs(a[1]), e), a[3] / a[4]);
    return 1.0 - numbers::pow(round + numbers::pow(std::abs(a[2]), n), a[4] * 0.5);
}

double torus(const double* a)
{
    const double ring = std::sqrt(a[0] * a[0] + a[2] * a[2]) - a[3];
    return std::sqrt(ring * ring + a[1] * a[1]) - a[4];
}

}  // namespace function
