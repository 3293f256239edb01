#pragma once

#include "numbers/functions/functions.h"
#include "render/light/illuminate.h"
#include "render/texture/finish.h"

#include <cmath>

/// What one light adds where nothing shadows it any more; shared by the tile's flat hits and the general shading.
namespace trace {

/// The colour of one node of an area light with area_illumination. seen: the light's own past what shadows it, whose
/// share the node has; the node's own cone and fading dim it.
inline glm::vec3 node_color(const light::Light& light, const light::Illumination& lit, const glm::vec3& seen)
{
    glm::vec3 color = seen * (1.0f / static_cast<float>(light.size1 * light.size2));
    for (int c = 0; c < 3; ++c)
        if (light.color[c] != 0.0f) color[c] *= lit.color[c] / light.color[c];
    return color;
}

/// A layer of a finish as light meets it. Unit vectors; `direction` is the ray's.
struct LitLayer {
    const texture::Finish& finish;
    const scene::Color& pigment;
    const glm::dvec3& direction;
    const glm::dvec3& normal;
    double alpha;
};

/// Strength of the highlights toward `l` (spec 3, 7.7).
inline double highlight(const LitLayer& layer, const glm::dvec3& l)
{
    const texture::Finish& finish = layer.finish;
    double strength = 0.0;
    if (finish.phong > 0.0f) strength += texture::phong(finish, layer.direction, layer.normal, l);
    if (finish.specular > 0.0f) strength += texture::specular(finish, layer.direction, layer.normal, l);
    return strength;
}

/// Cosine of a layer's normal with the light, raised to the finish's brilliance.
inline double raised_facing(const LitLayer& layer, const glm::dvec3& l)
{
    const double facing = std::abs(glm::dot(layer.normal, l));
    const float brilliance = layer.finish.brilliance;
    return brilliance == 1.0f ? facing : numbers::pow(facing, static_cast<double>(brilliance));
}

/// Diffuse light and highlights toward `l` (spec 3, 7.5 to 7.8). behind: on the side that diffuse_back lights;
/// strength: of the highlights; grain: what crand takes off; raised: raised_facing(), asked for where diffuse light is.
template <class Raised>
inline glm::vec3 surface_light(const LitLayer& layer, const glm::dvec3& l, const glm::vec3& color, bool behind,
                               double strength, double grain, Raised&& raised)
{
    const texture::Finish& finish = layer.finish;
    glm::vec3 sum(0);
    const auto diffuse = static_cast<double>(behind ? finish.diffuse_back : finish.diffuse);
    if (diffuse > 0.0) {
        double intensity = raised();
        intensity *= diffuse * layer.alpha;
        intensity -= grain;
        sum += static_cast<float>(intensity) * layer.pigment.rgb() * color;
    }
    if (strength != 0.0)
        sum += static_cast<float>(strength) *
               texture::highlight_color(finish, color, layer.pigment, layer.direction, layer.normal, l);
    return sum;
}

inline glm::vec3 surface_light(const LitLayer& layer, const glm::dvec3& l, const glm::vec3& color, bool behind,
                               double strength, double grain)
{
    return surface_light(layer, l, color, behind, strength, grain, [&] { return raised_facing(layer, l); });
}

}  // namespace trace
