#pragma once

#include "numbers/functions/functions.h"
#include "render/kernel/context/side_textures.h"
#include "render/texture/finish.h"

#include <cmath>

namespace trace {

/// What layers leave of light that comes straight at a normal. power: of caustics
inline glm::vec3 past_layers(const plan::CompiledScene& scene, const texture::Texture& texture, const glm::dvec3& p,
                             texture::Surroundings& around, const glm::dvec3& normal, texture::Enclosing& enclosing,
                             float power)
{
    const auto& set = scene.textures;
    glm::vec3 light(1);
    for (std::uint32_t i = texture.count; i-- > 0;) {
        const texture::Layer& layer = set.layers[texture.first + i];
        // Where a picture is not, it filters nothing, but focuses light as the rest of its surface does.
        if (!texture::pigment_missing(set, layer.pigment, p, around)) {
            const scene::Color c = texture::pigment_color(set, layer.pigment, p, around);
            light *= texture::passed(c);
        }
        if (power != 0.0f) {
            const glm::dvec3 n = texture::bent_normal(set, layer.normal, normal, p, around, enclosing);
            const double focus = numbers::pow(std::abs(glm::dot(n, around.direction)), static_cast<double>(power));
            light *= static_cast<float>(1.0 + focus);
        }
    }
    return light;
}

/// What a surface leaves of light (spec 3, 13.2). kept: room for the shares of parts
inline glm::vec3 surface_filter(const plan::CompiledScene& scene, const csg::World& world, const glm::dvec3& direction,
                                const Hit& hit, const HitDetails& details, std::vector<csg::Share>& kept)
{
    const plan::Surface& surface = scene.surfaces[hit.surface];
    const bool inside = from_inside(details, direction);
    const SideTextures shown(scene, world, hit, details, inside, kept);
    if (shown.size() == 0) return glm::vec3(1.0f);
    const glm::dvec3 normal = inside ? -details.normal : details.normal;
    const float power = surface.interior == plan::kNone ? 0.0f : scene.interiors[surface.interior].caustics_power;
    texture::Surroundings around{details.point, normal, direction, details.uv, true};
    texture::Enclosing enclosing;
    glm::vec3 light(0);
    shown.each_layers(surface.pattern_point(details.point, details.uv), around, enclosing,
                      [&](const texture::Texture& layers, const glm::dvec3& p, float share) {
                          light += share * past_layers(scene, layers, p, around, normal, enclosing, power);
                      });
    return light;
}

}  // namespace trace
