#pragma once

#include "csg/base/hit.h"
#include "csg/base/roundings.h"
#include "csg/base/tolerance.h"
#include "csg/solids/solid.h"

#include <cmath>

/// Depths and normals of hits with the last bits of POV-Ray's formulas (spec 5a, 5.1 and 5.3; 7d, 9), for the solids on
/// which scenes show them. What a ray meets is found by formulas that lose no digits; this is asked once it is known.
namespace csg {

inline bool has_last_bits(Roundings by, PartId part)
{
    return by != Roundings::Own && (kind_of(part) == SolidKind::Sphere || kind_of(part) == SolidKind::Cylinder);
}

inline double povray_depth(const Sphere& s, const Ray& ray, double t, std::uint32_t, Roundings)
{
    const glm::dvec3 to = s.center - ray.origin;
    const double along = glm::dot(to, ray.direction),
                 half = std::sqrt(s.radius * s.radius - glm::dot(to, to) + along * along);
    return t < along ? along - half : along + half;
}

/// On the ray in the cylinder's own frame, along a direction of length 1 there.
inline double povray_depth(const Cylinder& c, const Ray& ray, double t, std::uint32_t face, Roundings by)
{
    const glm::dvec3 o = c.frame.inverse_linear * ray.origin + c.frame.inverse_offset,
                     v = c.frame.inverse_vector(ray.direction), d = unit(v, by);
    const double length = glm::length(v);
    if (face == kLowEnd || face == kHighEnd) return ((face == kHighEnd ? 1.0 : 0.0) - o.z) / d.z / length;
    const double a2 = d.x * d.x + d.y * d.y, half_b = o.x * d.x + o.y * d.y, c0 = o.x * o.x + o.y * o.y - 1.0,
                 root = std::sqrt(half_b * half_b - a2 * c0), near = (-half_b - root) / a2 / length,
                 far = (-half_b + root) / a2 / length;
    return std::abs(near - t) < std::abs(far - t) ? near : far;
}

inline glm::dvec3 povray_normal(const Sphere& s, const glm::dvec3& p, std::uint32_t, Roundings by)
{
    const glm::dvec3 from = p - s.center;
    return by == Roundings::V37 ? from * (1.0 / s.radius) : from / s.radius;
}

inline glm::dvec3 povray_normal(const Cylinder& c, const glm::dvec3& p, std::uint32_t face, Roundings by)
{
    if (face != kSide) return unit(c.frame.normal({0.0, 0.0, face == kLowEnd ? -1.0 : 1.0}), by);
    const glm::dvec3 local = c.frame.inverse_linear * p + c.frame.inverse_offset;
    return unit(c.frame.normal({local.x, local.y, 0.0}), by);
}

/// How deep a hit lies by that program's numbers; where these have lost digits, as from afar, as it was found.
inline double told_depth(const SolidStore& store, const Ray& ray, const Hit& hit, Roundings by)
{
    if (!has_last_bits(by, hit.part)) return hit.t;
    const double told = kind_of(hit.part) == SolidKind::Sphere
                            ? povray_depth(store.all<Sphere>()[index_of(hit.part)], ray, hit.t, hit.face, by)
                            : povray_depth(store.all<Cylinder>()[index_of(hit.part)], ray, hit.t, hit.face, by);
    const glm::dvec3 size = glm::abs(ray.origin);
    return std::abs(told - hit.t) <= Tolerance::same_place(hit.t, glm::max(size.x, glm::max(size.y, size.z))) ? told
                                                                                                              : hit.t;
}

inline glm::dvec3 told_normal(const SolidStore& store, const Hit& hit, const glm::dvec3& point, Roundings by)
{
    constexpr double kUnit = 1e-12;  // longer and shorter ones come from points that have lost digits
    const glm::dvec3 own = normal_at(store, hit.part, hit.face, hit.inverted, point);
    if (!has_last_bits(by, hit.part)) return own;
    const glm::dvec3 told = kind_of(hit.part) == SolidKind::Sphere
                                ? povray_normal(store.all<Sphere>()[index_of(hit.part)], point, hit.face, by)
                                : povray_normal(store.all<Cylinder>()[index_of(hit.part)], point, hit.face, by);
    if (!(std::abs(glm::dot(told, told) - 1.0) < kUnit)) return own;
    return hit.inverted ? -told : told;
}

}  // namespace csg
