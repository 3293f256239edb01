#pragma once

#include <glm/glm.hpp>

namespace scene {

/// A colour in the working (linear) space, single precision as POV-Ray stores it.
/// filter: share of light let through tinted by rgb; transmit: share let through untinted.
struct Color {
    float red = 0, green = 0, blue = 0, filter = 0, transmit = 0;

    glm::vec3 rgb() const { return {red, green, blue}; }
    static Color of(const glm::vec3& rgb) { return {rgb.x, rgb.y, rgb.z, 0, 0}; }
    friend bool operator==(const Color&, const Color&) = default;
};

/// POV-Ray's luminance weights.
inline float grey(const glm::vec3& c) { return 0.297f * c.x + 0.589f * c.y + 0.114f * c.z; }

}  // namespace scene
