#include "render/plan/sampling/path_scene.h"

#include <algorithm>

namespace plan {

void prepare_for_paths(scene::Description& description)
{
    constexpr int kNoAmbient = 370;  // the first version in which radiosity takes the place of ambient (spec 6, 4.2)
    description.global.radiosity.reset();
    description.global.photons.reset();
    description.global.subsurface.reset();
    if (description.effective_version >= kNoAmbient) description.global.ambient_light = glm::vec3(0);
}

bool has_light(const CompiledScene& scene)
{
    const auto bright = [](const glm::vec3& c) { return c != glm::vec3(0); };
    const auto& lights = scene.lights.lights;
    if (std::any_of(lights.begin(), lights.end(), [&](const light::Light& light) { return bright(light.color); }))
        return true;
    if (!scene.sky.layers.empty() || bright(scene.sky.background.rgb())) return true;
    const auto& finishes = scene.textures.finishes;
    if (std::any_of(finishes.begin(), finishes.end(),
                    [&](const texture::Finish& f) { return bright(f.ambient + f.emission); }))
        return true;
    // Fog and media have light of their own, too.
    return !scene.fogs.empty() || !scene.rainbows.empty() || !scene.media.media.empty();
}

}  // namespace plan
