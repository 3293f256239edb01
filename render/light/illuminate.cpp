#include "render/light/illuminate.h"
#include "numbers/functions/functions.h"

#include <algorithm>
#include <cmath>

namespace light {
namespace {

/// 0 below low, 1 from high on, a cubic between.
double smooth_step(double low, double high, double x)
{
    if (x < low) return 0.0;
    if (x >= high) return 1.0;
    const double t = (x - low) / (high - low);
    return t * t * (3.0 - 2.0 * t);
}

/// v^power, with short cuts for the exponents that most scenes write, 1 and 2. At most one square in a thousand differs
/// from pow(), in its last bit.
double raised(double v, double power)
{
    if (power == 1.0) return v;
    return power == 2.0 ? v * v : numbers::pow(v, power);
}

double spot(const Light& light, const Illumination& lit)
{
    // The axis points away from the light, the direction toward it.
    double u = -glm::dot(light.axis, lit.direction);
    if (lit.distance <= 0.0) u = -u;
    if (u <= 0.0) return 0.0;
    double factor = light.tightness == 0.0 ? 1.0 : raised(u, light.tightness);
    if (light.cos_radius > 0.0 && u < light.cos_radius) factor *= smooth_step(light.cos_falloff, light.cos_radius, u);
    return factor;
}

double cylinder(const Light& light, const glm::dvec3& point)
{
    const glm::dvec3 from = point - light.location;
    const double along = glm::dot(from, light.axis);
    if (along <= 0.0) return 0.0;
    const double rho = glm::length(from - along * light.axis);
    if (rho >= light.falloff) return 0.0;
    const double delta = 1.0 - rho / light.falloff;
    double factor = light.tightness == 0.0 ? 1.0 : raised(delta, light.tightness);
    if (light.radius > 0.0 && rho > light.radius) factor *= smooth_step(0.0, 1.0 - light.radius / light.falloff, delta);
    return factor;
}

double attenuation(const Light& light, const Illumination& lit, const glm::dvec3& point)
{
    double factor = 1.0;
    if (light.kind == Light::Kind::Spot) factor = spot(light, lit);
    if (light.kind == Light::Kind::Cylinder) factor = cylinder(light, point);
    if (factor > 0.0 && light.fade_power > 0.0 && std::abs(light.fade_distance) > kLeastFadeDistance)
        factor *= 2.0 / (1.0 + raised(lit.distance / light.fade_distance, light.fade_power));
    return factor;
}

}  // namespace

Illumination toward(const Light& light, const glm::dvec3& point, const glm::dvec3& offset)
{
    const glm::dvec3 at = light.location + offset;
    const glm::dvec3 to = at - point;
    Illumination out;
    if (light.kind == Light::Kind::Cylinder || (light.parallel && light.area)) {
        out.direction = glm::normalize(at - light.point_at);
        out.distance = glm::dot(to, out.direction);
    } else if (light.parallel) {
        out.direction = -light.axis;
        out.distance = glm::dot(to, out.direction);
    } else {
        out.distance = glm::length(to);
        out.direction = to / out.distance;
    }
    return out;
}

Illumination illuminate(const Light& light, const glm::dvec3& point, const glm::dvec3& offset)
{
    Illumination out = toward(light, point, offset);
    out.color = color_at(light, out, point);
    return out;
}

glm::vec3 color_at(const Light& light, const Illumination& seen, const glm::dvec3& point)
{
    return steady_color(light) ? light.color : light.color * static_cast<float>(attenuation(light, seen, point));
}

AreaAxes oriented_axes(const Light& light, const glm::dvec3& point)
{
    const glm::dvec3 d = light.parallel ? -light.axis : glm::normalize(light.location - point);
    const glm::dvec3 t = std::abs(std::abs(d.z) - 1.0) < 0.01 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    const double size = glm::length(light.axis1);
    const glm::dvec3 a = glm::normalize(glm::cross(d, t)), b = glm::normalize(glm::cross(d, size * a));
    return {a, b, size};
}

NodeShares node_shares(const Light& light, double i, double j)
{
    const auto share = [](double k, int size) { return size > 1 ? k / (size - 1) - 0.5 : 0.0; };
    double p = share(i, light.size1), q = share(j, light.size2);
    if (!light.circular) return {p, q, 1.0};
    p += kCircleShift;
    q += kCircleShift;
    return {p, q, std::max(std::abs(p), std::abs(q)) / std::sqrt(p * p + q * q)};
}

glm::dvec3 node_offset(const Light& light, const glm::dvec3& point, double i, double j)
{
    const auto [p, q, m] = node_shares(light, i, j);
    if (!light.circular || !light.orient) return (p * m) * light.axis1 + (q * m) * light.axis2;
    const AreaAxes axes = oriented_axes(light, point);
    return (axes.size * p * m) * axes.a + (axes.size * q * m) * axes.b;
}

}  // namespace light
