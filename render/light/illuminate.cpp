#include "render/light/illuminate.h"
#include "render/light/attenuation.h"

#include <algorithm>
#include <cmath>

namespace light {

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
    return steady_color(light)
               ? light.color
               : light.color * static_cast<float>(attenuation(light, point, seen.direction, seen.distance, true));
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
