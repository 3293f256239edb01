#pragma once

#include "render/kernel/path/draws.h"
#include "render/kernel/path/lamp_faces.h"
#include "render/kernel/queue/ray_queue.h"

namespace trace::path {

/// A path that is being followed, beside the ray that it is at.
struct Walk {
    glm::vec3 throughput{1}, radiance{0};
    Draws draws;
    std::size_t owner = 0;  ///< of the samples at hand
    int bounces = 0;
    double pdf = 0;     ///< of the ray's direction, by solid angle; 0: the camera's, a mirror's or what goes through
    double length = 0;  ///< so far
    bool seen = false;  ///< the first surface that scatters is behind it
    Chain chain;
};

}  // namespace trace::path
