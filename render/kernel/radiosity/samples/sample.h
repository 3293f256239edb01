#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace trace::radiosity {

/// Light that arrives at a point from all of its surroundings, kept to be used again nearby (Ward, Rubinstein, Clear: A
/// ray tracing solution for diffuse interreflection, 1988; spec 6, 4.4).
struct Sample {
    glm::dvec3 point{0};
    glm::vec3 normal{0}, color{0};
    glm::vec3 nearest_way{0};  ///< unit, to what is nearest; zero: nothing is there
    float nearest = 0;         ///< distance of that
    float reach = 0;           ///< harmonic mean of the distances of all rays, within limits
    float quality = 1;         ///< 0 to 1: of how much of it rays were followed far enough
};

/// A sample and for points of which bounce it is: 0 for those that the camera sees.
struct Found {
    int bounce;
    Sample sample;
};

}  // namespace trace::radiosity
