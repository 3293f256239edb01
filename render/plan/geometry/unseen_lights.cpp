#include "render/plan/geometry/unseen_lights.h"
#include "numbers/functions/functions.h"

#include <algorithm>

namespace plan {
namespace {

/// Whether light groups let it shine on some surface, or what fills space scatters it (spec 3, 12.10; spec 6, 2.6).
bool has_receiver(const CompiledScene& scene, const light::Light& light)
{
    if (light.group == 0 && (!scene.media.media.empty() || !scene.fogs.empty())) return true;
    return std::any_of(scene.surfaces.begin(), scene.surfaces.end(), [&](const Surface& surface) {
        return light.group == surface.light_group || (light.group == 0 && surface.global_lights);
    });
}

/// Whether the cone of a spotlight comes near the ball around a box.
bool reaches(const light::Light& light, const csg::Aabb& box)
{
    constexpr double kSlack = 1e-3;  // of the ball's radius and in radians: points of hits lie beside surfaces
    if (box.empty()) return false;
    if (!box.finite()) return true;
    const glm::dvec3 to = 0.5 * (box.lower + box.upper) - light.location;
    const double distance = glm::length(to),
                 radius = (1.0 + kSlack) * 0.5 * glm::length(box.upper - box.lower) + kSlack * kSlack * distance;
    if (!(distance > radius)) return true;
    const double edge = light.cos_radius > 0.0 ? std::min(light.cos_falloff, light.cos_radius) : 0.0;
    const double widest = numbers::acos(std::clamp(edge, 0.0, 1.0)) + numbers::asin(radius / distance) + kSlack;
    return numbers::acos(std::clamp(glm::dot(light.axis, to) / distance, -1.0, 1.0)) <= widest;
}

/// Whether all that a light does is to shine on surfaces, from one point: where its cone ends is known then.
bool only_a_cone(const CompiledScene& scene, const light::Light& light, const PhotonPlan* photons)
{
    return light.kind == light::Light::Kind::Spot && !light.parallel && !light.area && light.projector == nullptr &&
           photons == nullptr && scene.media.media.empty();
}

/// Whether grain or light below surfaces is drawn by the order of lights.
bool order_matters(const CompiledScene& scene)
{
    return scene.options.grain_stream ||
           std::any_of(scene.textures.finishes.begin(), scene.textures.finishes.end(),
                       [](const texture::Finish& finish) { return finish.crand != 0.0f || finish.subsurface; });
}

}  // namespace

std::vector<bool> received_lights(const CompiledScene& scene, const PhotonPlan* photons)
{
    const auto& lights = scene.lights.lights;
    std::vector<bool> out(lights.size(), true);
    if (order_matters(scene)) return out;
    const csg::WorldData& world = scene.geometry;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        out[i] = has_receiver(scene, lights[i]);
        if (!out[i] || !only_a_cone(scene, lights[i], photons)) continue;
        out[i] = std::any_of(world.items.begin(), world.items.end(), [&](const csg::WorldItem& item) {
            return reaches(lights[i], csg::drawn_bounds(world, item));
        });
    }
    return out;
}

}  // namespace plan
