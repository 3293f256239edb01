#pragma once

#include "csg/solids/shared/outline_shape.h"
#include "tests/csg/support.h"

#include <algorithm>
#include <cmath>

/// Profiles of solids of revolution, asked in the plainest way.
namespace csg_test {

using csg::OutlinePiece;
using csg::Ray;

using Curve = std::vector<OutlinePiece>;

/// A point of a profile: distance from the axis, and height.
struct Profile {
    long double radius, height;
};

inline Profile at(const OutlinePiece& p, long double w)
{
    const auto of = [&](int k) { return ((p.a[k] * w + p.b[k]) * w + p.c[k]) * w + p.d[k]; };
    return {of(0), of(1)};
}

/// Positive where a circle lies outside of what the ray sweeps about the axis: in extended precision, without a closed
/// form.
inline long double beyond(const Ray& ray, const Profile& p)
{
    const long double ox = ray.origin.x, oz = ray.origin.z, dx = ray.direction.x, dy = ray.direction.y,
                      dz = ray.direction.z;
    const long double up = p.height - ray.origin.y, x = dy * ox + up * dx, z = dy * oz + up * dz;
    return dy * dy * p.radius * p.radius - x * x - z * z;
}

/// How often the profile crosses what the ray sweeps; -1 where a tangent leaves it open.
inline int crossings(const Curve& curve, const Ray& ray)
{
    constexpr int kSteps = 3000;
    constexpr long double kClose = 1e-5L;
    int found = 0;
    for (const OutlinePiece& piece : curve) {
        long double before = beyond(ray, at(piece, 0)), earlier = before;
        for (int i = 1; i <= kSteps; ++i) {
            const long double now = beyond(ray, at(piece, static_cast<long double>(i) / kSteps));
            if ((before > 0) != (now > 0)) ++found;
            const bool turns = i > 1 && std::abs(before) < std::abs(earlier) && std::abs(before) < std::abs(now);
            if (turns && std::abs(before) < kClose && (earlier > 0) == (now > 0) && (before > 0) == (now > 0))
                return -1;
            earlier = before;
            before = now;
        }
    }
    return found;
}

/// Distance of a point from a profile, nearest of many samples and then by thirds.
inline double off(const Curve& curve, const glm::dvec3& p)
{
    const long double rho = std::sqrt(static_cast<long double>(p.x) * p.x + static_cast<long double>(p.z) * p.z);
    const auto distance = [&](const OutlinePiece& piece, long double w) {
        const Profile q = at(piece, w);
        return std::hypot(q.radius - rho, q.height - static_cast<long double>(p.y));
    };
    long double least = 1e30L;
    for (const OutlinePiece& piece : curve) {
        constexpr int kSteps = 400;
        int best = 0;
        long double nearest = 1e30L;
        for (int i = 0; i <= kSteps; ++i) {
            const long double d = distance(piece, static_cast<long double>(i) / kSteps);
            if (d < nearest) nearest = d, best = i;
        }
        long double lo = static_cast<long double>(std::max(best - 1, 0)) / kSteps,
                    hi = static_cast<long double>(std::min(best + 1, kSteps)) / kSteps;
        for (int i = 0; i < 120; ++i) {
            const long double a = lo + (hi - lo) / 3, b = hi - (hi - lo) / 3;
            if (distance(piece, a) < distance(piece, b)) hi = b;
            else lo = a;
        }
        least = std::min({least, nearest, distance(piece, (lo + hi) / 2)});
    }
    return static_cast<double>(least);
}

inline Curve spline(const std::vector<glm::dvec2>& points)
{
    Curve curve;
    for (std::size_t i = 0; i + 3 < points.size(); ++i) {
        const glm::dvec2 &p0 = points[i], &p1 = points[i + 1], &p2 = points[i + 2], &p3 = points[i + 3];
        curve.push_back({-0.5 * p0 + 1.5 * p1 - 1.5 * p2 + 0.5 * p3, p0 - 2.5 * p1 + 2.0 * p2 - 0.5 * p3,
                         0.5 * (p2 - p0), p1, p1, p2});
    }
    return curve;
}

inline Curve polyline(const std::vector<glm::dvec2>& points)
{
    Curve curve;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) curve.push_back(OutlinePiece::line(points[i], points[i + 1]));
    return curve;
}

/// From anywhere, nearly level, nearly upright, and nearly through the axis.
inline Ray some_ray(Rng& rng, std::uint32_t seed, double middle)
{
    Ray ray = csg_test::ray_near(rng, {0, middle, 0}, 1.3, rng.coin() ? 6.0 : 0.6);
    const double small = std::pow(10.0, rng.uniform(-12.0, -1.0));
    if (seed % 5 == 1) ray.direction.y *= small;
    if (seed % 5 == 2)
        ray.direction *= glm::dvec3(small, 1.0, small), ray.origin.x = rng.uniform(-1.2, 1.2),
                                                        ray.origin.z = rng.uniform(-1.2, 1.2);
    if (seed % 5 == 3)
        ray.direction = glm::dvec3(-ray.origin.x, ray.direction.y, -ray.origin.z) + small * rng.point(1.0);
    ray.direction = glm::normalize(ray.direction);
    return ray;
}

}  // namespace csg_test
