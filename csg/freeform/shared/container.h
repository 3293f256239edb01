#pragma once

#include "csg/solids/shared/slab.h"
#include "csg/solids/shared/common.h"

namespace csg {

/// The sphere or box that bounds an isosurface or a parametric surface (reference manual: contained_by).
struct Container {
    glm::dvec3 lower{-1.0}, upper{1.0};  ///< of the box, sorted
    glm::dvec3 center{0.0};              ///< of the sphere
    double radius = 0.0;
    bool is_sphere = false;

    static constexpr std::uint32_t kSphereFace = 6;  ///< the box has faces 0 to 5: axis * 2 + (1: the upper one)

    static Container box(const glm::dvec3& a, const glm::dvec3& b)
    {
        return {.lower = glm::min(a, b), .upper = glm::max(a, b)};
    }
    static Container sphere(const glm::dvec3& center, double radius)
    {
        return {.center = center, .radius = std::abs(radius), .is_sphere = true};
    }

    Aabb bounds() const { return is_sphere ? Aabb{center - radius, center + radius} : Aabb{lower, upper}; }
    bool contains(const glm::dvec3& p) const
    {
        if (is_sphere) return glm::dot(p - center, p - center) <= radius * radius;
        return glm::all(glm::greaterThanEqual(p, lower)) && glm::all(glm::lessThanEqual(p, upper));
    }
    /// Along the whole line; false: not met, or where numbers end.
    bool interval(const Ray& ray, Interval& out) const
    {
        if (is_sphere) return sphere_interval(ray, out);
        out = Interval{};
        return narrow(out, ray, lower, upper) && out.exit - out.entry < kInfinity;
    }
    glm::dvec3 normal(const glm::dvec3& p, std::uint32_t face) const
    {
        if (face == kSphereFace) return p - center;
        glm::dvec3 n(0.0);
        n[static_cast<int>(face / 2)] = face % 2 == 0 ? -1.0 : 1.0;
        return n;
    }

private:
    bool sphere_interval(const Ray& ray, Interval& out) const
    {
        const glm::dvec3 away = ray.origin - center;
        const double a = glm::dot(ray.direction, ray.direction), foot = -glm::dot(away, ray.direction) / a;
        const glm::dvec3 nearest = away + foot * ray.direction;  // no large numbers are subtracted from each other
        const double below = radius * radius - glm::dot(nearest, nearest);
        if (!(below > 0.0) || !(a > 0.0)) return false;
        const double half = std::sqrt(below / a);
        out = {foot - half, foot + half, kSphereFace, kSphereFace};
        return half < kInfinity;
    }
};

}  // namespace csg
