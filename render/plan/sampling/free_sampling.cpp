#include "render/plan/sampling/free_sampling.h"

namespace plan {

void free_light(light::Light& light)
{
    if (!light.area) return;
    const auto cover = [&](int& size, glm::dvec3& axis) {
        if (size <= 1) return;
        if (!light.area_illumination) size = 2;  // else its nodes light the surface from where they are, unmoved
        axis *= static_cast<double>(size - 1) / size;
    };
    cover(light.size1, light.axis1);
    cover(light.size2, light.axis2);
    light.jitter = true;
    light.adaptive = 0;
}

void free_lens(scene::Camera& camera)
{
    constexpr int kPlaces = 19;  // the smallest set that covers a round lens evenly (spec 2, section 7)
    if (camera.aperture == 0.0 || camera.blur_samples <= 0) return;
    camera.blur_samples = camera.blur_fewest = kPlaces;
    camera.variance = 0.0;
}

}  // namespace plan
