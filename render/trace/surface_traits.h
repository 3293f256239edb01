#pragma once

#include "render/plan/compiled_scene.h"

#include <vector>

/// What shading can know of a surface before any ray meets it.
namespace trace {

struct SurfaceTraits {
    bool needs_uv = true;        ///< something of its textures looks at surface coordinates
    bool steady_filter = false;  ///< light that passes is filtered alike everywhere and in every direction
    std::uint32_t outer_layer = plan::kNone;   ///< the only layer where seen from outside, if the small kernel can do it
    std::uint32_t inner_layer = plan::kNone;   ///< the same where the raw normal faces along the ray
    glm::vec3 filter{1};         ///< steady_filter: by this (spec 3, 13.2)
};

/// By csg::SurfaceId.
std::vector<SurfaceTraits> surface_traits(const plan::CompiledScene& scene);

}  // namespace trace
