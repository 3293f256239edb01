#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace trace {

/// A photon on its way from the light.
struct Emission {
    glm::dvec3 origin, direction;
    glm::vec3 color;
    double depth;        ///< way that it has come before `origin`
    std::uint32_t ring;  ///< that it belongs to
};

}  // namespace trace
