#pragma once

#include "render/light/light_set.h"

/// Direction, distance and colour of the light that reaches a point if nothing stands between (spec 3, 12.2 to 12.4).
namespace light {

struct Illumination {
    glm::dvec3 direction{0};  ///< unit, from the point toward the light
    double distance = 0;      ///< along direction; may be negative for parallel lights
    glm::vec3 color{0};       ///< after cone and distance attenuation
};

/// `offset`: of a sample of an area light from its centre.
Illumination illuminate(const Light& light, const glm::dvec3& point, const glm::dvec3& offset = glm::dvec3(0));

/// Whether neither cone nor distance dims the light.
inline bool steady_color(const Light& light) { return light.kind == Light::Kind::Point && !(light.fade_power > 0.0); }

/// Whether every point sees one place of the light in the same direction.
inline bool seen_in_one_direction(const Light& light) { return light.kind == Light::Kind::Cylinder || light.parallel; }

/// The colour of a light at a point, after attenuation by its cone and by distance. `seen`: toward() of the point.
glm::vec3 color_at(const Light& light, const Illumination& seen, const glm::dvec3& point);

/// Direction (unit) and distance to the light alone, for the shadow rays of an area light's sample.
Illumination toward(const Light& light, const glm::dvec3& point, const glm::dvec3& offset);

/// Where the axes of a light that turns to the point it lights lie (`orient`): a and b are unit vectors, both as long
/// as `size`.
struct AreaAxes {
    glm::dvec3 a, b;
    double size;
};
AreaAxes oriented_axes(const Light& light, const glm::dvec3& point);  ///< (spec 3, 12.5)

inline constexpr double kCircleShift =
    0.001;  ///< of a circular light's nodes: really part of POV-Ray's positions (spec 3, 12.5)

/// Where node (i, j) of an area light lies: shares p and q of its edges, from the middle, both times m, which draws the
/// nodes of a circular light in to a circle.
struct NodeShares {
    double p, q, m;
};
NodeShares node_shares(const Light& light, double i, double j);

/// Offset of the node (i, j) of an area light; i and j may be moved by jitter (spec 3, 12.5).
glm::dvec3 node_offset(const Light& light, const glm::dvec3& point, double i, double j);

}  // namespace light
