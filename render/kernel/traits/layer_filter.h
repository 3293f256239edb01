#pragma once

#include "render/texture/finish.h"

#include <algorithm>
#include <cmath>

namespace trace {

/// What the only layer of a texture lets through, in LayerStack::pass()'s order of operations.
inline glm::vec3 layer_filter(const scene::Color& c, const texture::Finish& finish, const glm::vec3& reflectivity)
{
    const glm::vec3 filter = c.filter * c.rgb() + c.transmit;
    return finish.conserve_energy ? filter * glm::min(glm::vec3(1.0f), 1.0f - reflectivity) : filter;
}
inline float residual_of(const glm::vec3& filter) { return std::min(1.0f, std::abs(scene::grey(filter))); }

}  // namespace trace
