#include "render/kernel/media/lit_ranges.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trace {
namespace {

constexpr double kNearlyZeroRange = 1e-10;
constexpr double kFar = 1e7;  // where a cone ends for POV-Ray

/// a t^2 + 2 b t + c: below zero inside of the cone or cylinder around a light's axis.
struct Quadratic {
    double a, b, c, discriminant;
    double along, start;  ///< position on the axis at t: start + t * along

    bool behind() const { return along <= 0.0 && start < 0.0; }
    std::pair<double, double> roots() const
    {
        const double d = std::sqrt(discriminant), t1 = (-b - d) / a, t2 = (-b + d) / a;
        return {std::min(t1, t2), std::max(t1, t2)};
    }
    double axial(double t) const { return start + t * along; }
};

/// \param m  how fast the radius grows along the axis; square: of a radius that does not grow
Quadratic quadratic_of(const light::Light& light, const csg::Ray& ray, double m, double square)
{
    const glm::dvec3 v = ray.origin - light.location;
    const double k1 = glm::dot(ray.direction, light.axis), k2 = glm::dot(v, light.axis);
    const double a = 1.0 - m * k1 * k1, b = glm::dot(v, ray.direction) - m * k1 * k2,
                 c = glm::dot(v, v) - m * k2 * k2 - square;
    return {a, b, c, b * b - a * c, k1, k2};
}

bool cone_range(const light::Light& light, const csg::Ray& ray, MediaRange& out)
{
    const Quadratic q = quadratic_of(light, ray, 1.0 / (light.cos_falloff * light.cos_falloff), 0.0);
    if (q.behind()) return false;
    if (q.discriminant < -kNearlyZeroRange && q.a != 0.0) return false;
    const double away = glm::length(ray.origin - light.location);
    const bool inside = away > kNearlyZeroRange && q.start / away >= light.cos_falloff;
    if (q.a == 0.0) {
        out = {0.0, -q.c / q.b};
        return inside;
    }
    if (q.discriminant > kNearlyZeroRange) {
        const auto [t1, t2] = q.roots();
        const double l1 = q.axial(t1), l2 = q.axial(t2);
        if (l1 <= 0.0 && l2 <= 0.0) return false;
        if (l1 <= 0.0) {
            if (inside) out = {0.0, t2 > 0.0 ? t2 : kFar};
            else out = {t2, kFar};
        } else if (l2 <= 0.0) {
            if (inside) out = {0.0, t1};
            else out = {t1, kFar};
        } else {
            out = {t1, t2};
        }
        return true;
    }
    // Along the axis: POV-Ray loses the light that the ray looks into (spec 6, 2.11).
    if (inside) out = {0.0, q.along > 0.0 ? kFar : -q.b / q.a};
    else out = {-q.b / q.a, kFar};
    return true;
}

bool cylinder_range(const light::Light& light, const csg::Ray& ray, MediaRange& out)
{
    const Quadratic q = quadratic_of(light, ray, 1.0, light.falloff * light.falloff);
    if (q.behind()) return false;
    if (q.a == 0.0 || q.discriminant <= kNearlyZeroRange) {
        // Along the axis: POV-Ray sees nothing (spec 6, 2.11).
        constexpr double kAlong = 1e-8;
        if (q.a > kAlong || q.c >= 0.0) return false;
        const double at_light = -q.start / q.along;
        out = q.along > 0.0 ? MediaRange{std::max(0.0, at_light), kFar} : MediaRange{0.0, at_light};
        return true;
    }
    auto [t1, t2] = q.roots();
    const double l1 = q.axial(t1), l2 = q.axial(t2);
    if (l1 <= 0.0 && l2 <= 0.0) return false;
    if (l1 <= 0.0) t1 = 0.0;
    else if (l2 <= 0.0) t2 = (kFar - q.start) / q.along;
    out = {t1, t2};
    return true;
}

}  // namespace

bool lit_range(const light::Light& light, const csg::Ray& ray, double length, MediaRange& out)
{
    constexpr double kNearest = 0.001;
    out = {0.0, length};
    switch (light.kind) {
    case light::Light::Kind::Point: return true;
    case light::Light::Kind::Spot:
        if (!cone_range(light, ray, out)) return false;
        break;
    case light::Light::Kind::Cylinder:
        if (!cylinder_range(light, ray, out)) return false;
        break;
    }
    if (!(out.from < length && out.to > kNearest)) return false;
    out = {std::max(out.from, 0.0), std::min(out.to, length)};
    return true;
}

}  // namespace trace
