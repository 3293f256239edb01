#include "csg/solids/solid.h"
#include "numbers/functions/functions.h"

#include <numbers>

namespace csg {

namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

glm::dvec2 Sphere::uv(const glm::dvec3& p, std::uint32_t) const { return sphere_uv(unit_or_x(p - center)); }

glm::dvec2 Ellipsoid::uv(const glm::dvec3& p, std::uint32_t) const
{
    return sphere_uv(unit_or_x(frame.inverse_point(p)));
}

glm::dvec2 box_uv(const glm::dvec3& local, const glm::dvec3& lower, const glm::dvec3& upper, std::uint32_t face)
{
    glm::dvec3 p(0.0);
    for (int i = 0; i < 3; ++i)
        if (upper[i] > lower[i]) p[i] = (local[i] - lower[i]) / (upper[i] - lower[i]);
    switch (face) {
    case kMinX: return {p.z / 4, 1.0 / 3 + p.y / 3};
    case kMaxX: return {0.75 - p.z / 4, 1.0 / 3 + p.y / 3};
    case kMinY: return {0.25 + p.x / 4, p.z / 3};
    case kMaxY: return {0.25 + p.x / 4, 1.0 - p.z / 3};
    case kMinZ: return {1.0 - p.x / 4, 1.0 / 3 + p.y / 3};
    default: return {0.25 + p.x / 4, 1.0 / 3 + p.y / 3};
    }
}

glm::dvec2 Torus::uv(const glm::dvec3& p, std::uint32_t) const
{
    const glm::dvec3 l = frame.inverse_point(p);
    const double rho = std::sqrt(l.x * l.x + l.z * l.z);
    return {1.0 - (numbers::atan2(l.z, l.x) + kPi) / (2.0 * kPi),
            (numbers::atan2(l.y, rho - major) + kPi) / (2.0 * kPi)};
}

glm::dvec3 Triangle::normal(const glm::dvec3& p, std::uint32_t) const
{
    const glm::dvec3 n = glm::cross(edge1, edge2);
    const double n2 = glm::dot(n, n);
    if (!smooth || !(n2 > 0.0)) return unit_or_x(n);
    const glm::dvec3 from = p - corner;
    const double u = glm::dot(glm::cross(from, edge2), n) / n2, v = glm::dot(glm::cross(edge1, from), n) / n2;
    return unit_or_x(normals[0] * (1.0 - u - v) + normals[1] * u + normals[2] * v);
}

}  // namespace csg
