#pragma once

#include "render/plan/media.h"

#include <glm/glm.hpp>

namespace plan {

/// What fills an object, ready for tracing (spec 3, sections 8 and 9). Its index is its identity.
struct Interior {
    float ior = 1, dispersion = 1;
    int dispersion_samples = 7;
    float caustics_power = 0;  ///< exponent of the faked caustics; 0: none
    float fade_distance = 0, fade_power = 0;
    glm::vec3 fade_color{0};
    float transmission = 1;  ///< legacy factor on transmitted light (finish `refraction`)
    bool hollow = false;
    MediaList media;

    /// Whether the way through it takes anything from light.
    bool dims() const { return fade_distance != 0.0f || media.extinguishes; }
};

}  // namespace plan
