#pragma once

#include "csg/hit.h"
#include "render/light/illuminate.h"
#include "render/trace/shade_lanes.h"
#include "render/trace/surface_traits.h"

#include <array>
#include <vector>

namespace trace {

/// One light at one shaded point: computed when first asked for, shared by all layers of the hit (spec 3, 13.4).
struct LightSample {
    light::Illumination lit;
    glm::vec3 shadowed{0};
    bool illuminated = false;    ///< `lit` is there
    bool shadow_known = false;   ///< `shadowed` is there
};

/// A hit of a tile on a plain surface, on its way through the lights.
struct PlainHit {
    const texture::Finish* finish = nullptr;   ///< none: not a hit, or not of a plain surface
    scene::Color pigment;
    glm::vec3 glow, lit;                       ///< ambient and emission; what the lights have added so far
};

/// What shading keeps per thread; grows to what the scene needs and stays.
struct ShadeScratch {
    std::vector<SurfaceTraits> surfaces; ///< of the scene; filled by the first tile
    std::vector<LightSample> lights;     ///< a stack: every shaded hit owns lights.size() entries at its level
    std::vector<glm::vec3> area_nodes;   ///< shadow values of the area light at hand; red below 0: not yet known
    csg::RayTile rays;                   ///< shadow rays of a tile
    TileHits hits;                       ///< of a tile
    TileLight light;                     ///< the one at hand
    std::array<glm::vec3, csg::kTileRays> lit_colors;   ///< of the light at hand, before shadows
    std::array<PlainHit, csg::kTileRays> plain;
    std::array<csg::Shadow, csg::kTileRays> shadows;
    std::array<csg::HitDetails, csg::kTileRays> details;
    std::array<std::uint8_t, csg::kTileRays> lane;   ///< of each shadow ray: which hit it belongs to
};

}  // namespace trace
