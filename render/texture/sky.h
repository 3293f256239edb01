#pragma once

#include "render/scene/base/color.h"
#include "render/scene/description.h"

#include <cstdint>
#include <vector>

namespace texture {

/// What a ray sees that hits nothing (spec 2, sections 14 and 15).
struct Sky {
    scene::Color background{0, 0, 0, 0, 1};  ///< as it is to be used: version and alpha rules applied
    std::vector<std::uint32_t> layers;       ///< pigments, the last is the top
    glm::vec3 emission{1};
    bool legacy = false;  ///< language version below 3.7
    bool alpha_output = false;
};

/// One fog (spec 2, section 16); distances in scene units.
struct Fog {
    bool ground = false, turbulent = false;
    double distance = 0, offset = 0, altitude = 0, turb_depth = 0.5;
    scene::Color color;
    scene::Turbulence turbulence;
    glm::dvec3 up{0, 1, 0};
};

/// It is the same everywhere.
inline bool even(const Fog& fog) { return !fog.ground && !fog.turbulent; }

/// One rainbow (spec 2, section 17); angles in radians, colours from the inner edge to the outer in TextureSet::keys
/// and colors.
struct Rainbow {
    glm::dvec3 antisolar{0}, right{0}, up{0};  ///< unit: where it is seen around, and the axes beside
    double angle = 0, width = 0, arc = 0, falloff = 0, distance = 0, jitter = 0;
    std::uint32_t first = 0, count = 0;
    scene::Blending blending;
};

}  // namespace texture
