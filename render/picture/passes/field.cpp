#include "render/kernel/radiosity/samples/field.h"

#include "render/picture/passes/directions/directions.h"

#include <algorithm>

namespace trace::radiosity {
namespace {

bool black_layers(const texture::TextureSet& set, std::uint32_t index)
{
    if (index == texture::kNone) return true;
    const texture::Texture& texture = set.textures[index];
    if (texture.kind != texture::Texture::Kind::Layers || !texture.opaque) return false;
    for (std::uint32_t i = texture.first; i < texture.first + texture.count; ++i) {
        const texture::Finish& finish = set.finishes[set.layers[i].finish];
        if (finish.ambient != glm::vec3(0) || finish.emission != glm::vec3(0) || finish.reflects() ||
            finish.subsurface || finish.extension != texture::kNone)
            return false;
    }
    return true;
}

/// By csg::SurfaceId, the surfaces that are black to a ray of the last bounce: they let nothing through, mirror nothing
/// and do not glow, and no lamp shines on anything. Empty where there are none, or where more than the surface decides
/// what such a ray brings.
std::vector<std::uint8_t> black_surfaces(const plan::CompiledScene& scene)
{
    const plan::Radiosity& radiosity = *scene.radiosity;
    const bool air = radiosity.settings.media &&
                     !(scene.fogs.empty() && scene.rainbows.empty() && scene.media.media.empty());
    // Where surfaces weigh differently the order of the sums counts.
    const bool even = radiosity.importance == 1.0f &&
                      std::all_of(scene.surfaces.begin(), scene.surfaces.end(),
                                  [](const plan::Surface& s) { return s.importance == 1.0f; });
    if (!radiosity.lights.lights.empty() || scene.photons != nullptr || scene.subsurface != nullptr || air || !even)
        return {};
    std::vector<std::uint8_t> black;
    for (const plan::Surface& s : scene.surfaces) {
        bool all = black_layers(scene.textures, s.texture) && black_layers(scene.textures, s.interior_texture) &&
                   black_layers(scene.textures, s.corner_textures[0]) &&
                   black_layers(scene.textures, s.corner_textures[1]);
        for (std::uint32_t k = 0; k < s.part_count; ++k)
            all = all && black_layers(scene.textures, scene.part_textures[s.first_part + k]);
        black.push_back(all ? 1 : 0);
    }
    return black;
}

}  // namespace

Field::Field(const plan::CompiledScene& scene) : plan(scene.radiosity), eye(scene.camera.location)
{
    for (int bounce = 0; bounce < settings().recursion_limit; ++bounce)
        rules.push_back(BounceRules::of(settings(), bounce));
    samples.resize(rules.size());
    directions = radiosity::directions(settings().pool_size());
    order = DirectionOrder(directions);
    black = black_surfaces(scene);
}

}  // namespace trace::radiosity
