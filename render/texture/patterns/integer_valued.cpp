#include "render/texture/points/angle.h"
#include "render/texture/patterns/patterns.h"

#include <array>
#include <cmath>

namespace texture {
namespace {

double positive_fraction(double v)
{
    const double f = v - std::trunc(v);
    return f < 0.0 ? f + 1.0 : f;
}

/// v modulo m with the sign of m.
double floor_mod(double v, double m) { return v - m * std::floor(v / m); }

}  // namespace

double checker(const glm::dvec3& p)
{
    const double sum = std::floor(p.x + kTiny) + std::floor(p.y + kTiny) + std::floor(p.z + kTiny);
    return floor_mod(sum, 2.0) == 1.0 ? 1.0 : 0.0;
}

/// vector: brick size; numbers: mortar, already less the 2e-10 that POV-Ray takes off.
double brick(const Pattern& pattern, const glm::dvec3& p)
{
    const glm::dvec3& size = pattern.vector;
    const double mortar = pattern.numbers[0];
    const glm::dvec3 q = p + (mortar + kTiny);
    if (positive_fraction(q.y / size.y) <= mortar / size.y) return 0.0;
    const bool lower = positive_fraction(q.y / (2.0 * size.y)) <= 0.5;
    if (positive_fraction(q.x / size.x + (lower ? 0.0 : 0.5)) <= mortar / size.x) return 0.0;
    if (positive_fraction(q.z / size.z + (lower ? 0.5 : 0.0)) <= mortar / size.z) return 0.0;
    return 1.0;
}

double hexagon(const glm::dvec3& p)
{
    // Nine digits are POV-Ray's: exact square roots would move the edges.
    constexpr double kPeriod = 5.196152424, kHalfHeight = 0.866025404;
    static constexpr std::array<int, 6> kOuter{0, 1, 1, 2, 2, 0}, kInner{2, 2, 0, 0, 1, 1};
    static constexpr std::array<int, 3> kBelow{0, 2, 1}, kAbove{2, 1, 0};
    const double x = floor_mod(std::abs(p.x) / 0.5, 6.0);
    const double z = floor_mod((p.z < 0.0 ? p.z + kPeriod : p.z) / kHalfHeight, 6.0);
    const int xm = static_cast<int>(x) % 6, zm = static_cast<int>(z) % 6;
    if (xm == 0 || xm == 5) return kOuter[static_cast<std::size_t>(zm)];
    if (xm == 2 || xm == 3) return kInner[static_cast<std::size_t>(zm)];
    double xl = x - xm;
    const double zl = z - zm;
    if ((xm + zm) % 2 == 1) xl = 1.0 - xl;
    if (xl == 0.0) xl = 0.0001;
    const auto column = static_cast<std::size_t>(zm % 3);
    return zl / xl < 1.0 ? kBelow[column] : kAbove[column];
}

double square(const glm::dvec3& p)
{
    const bool a = floor_mod(std::floor(p.x), 2.0) == 1.0, b = floor_mod(std::floor(p.z), 2.0) == 1.0;
    return a ? (b ? 2.0 : 3.0) : (b ? 1.0 : 0.0);
}

double cubic(const glm::dvec3& p)
{
    const glm::dvec3 a = glm::abs(p);
    if (p.x >= a.y && p.x >= a.z) return 0.0;
    if (p.y >= a.x && p.y >= a.z) return 1.0;
    if (p.z >= a.x && p.z >= a.y) return 2.0;
    if (a.x >= a.y && a.x >= a.z) return 3.0;
    return a.y >= a.x && a.y >= a.z ? 4.0 : 5.0;
}

double triangular(const glm::dvec3& p)
{
    const double q = std::sqrt(3.0);
    double x = floor_mod(p.x, 3.0), z = floor_mod(p.z, q);
    const bool upper = z >= q / 2.0;
    if (upper) z = q - z;
    const double a = std::floor(x);
    x -= a;
    double c;
    if (z >= q * x) c = floor_mod(1.0 + 2.0 * a, 6.0);
    else if (z >= q * (1.0 - x)) c = floor_mod(3.0 + 2.0 * a, 6.0);
    else c = floor_mod(-2.0 * a, 6.0);
    return upper ? 5.0 - c : c;
}

}  // namespace texture
