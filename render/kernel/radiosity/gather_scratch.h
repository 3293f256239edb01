#pragma once

#include "csg/base/hit.h"
#include "render/scene/base/color.h"
#include "render/kernel/radiosity/samples/sample.h"

#include <array>
#include <vector>

namespace trace::radiosity {

/// A hit that asks what light arrives from its surroundings.
struct Request {
    glm::dvec3 point, normal;  ///< the normal faces the viewer
    glm::dvec3 bent;           ///< the layer's, or the same
    double weight;             ///< of what comes, as a share of the pixel
    double start;              ///< nearer crossings are the point's own surface
    std::uint8_t lane, root;   ///< of the tile: the hit, and the ray that it stems from
};

/// What was found for it so far: weight and weighted colours of samples.
struct Lookup {
    double bound = 0;  ///< of the error
    double weight = 0;
    glm::dvec3 sum{0};
};

/// A sample while its rays are traced.
struct Gathering {
    glm::dvec3 x{0}, y{0}, z{0};  ///< the frame that directions are turned into
    std::size_t next = 0;         ///< direction
    int examined = 0;             ///< directions tried against the true normal
    bool bent = false;            ///< they are about a bent normal
    int unbent = 0;               ///< rays about the true one, when too many went into the surface
    int rays = 0;
    glm::dvec3 sum{0};
    double quality = 0, inverse = 0, nearest = 0;
    glm::dvec3 nearest_way{0};
};

/// A ray of a sample, until there are enough of them to be put in order.
struct GatherRay {
    glm::dvec3 direction;
    std::uint16_t number;  ///< of the sample's
    std::uint8_t owner;    ///< request
};

/// What gathering keeps per thread and bounce.
struct GatherScratch {
    std::array<Request, csg::kTileRays> requests;
    std::array<Lookup, csg::kTileRays> lookups;
    std::array<glm::vec3, csg::kTileRays> ambient;  ///< by request: the answer
    std::array<Gathering, csg::kTileRays> gatherings;
    std::array<Sample, csg::kTileRays> made;  ///< by request
    std::array<bool, csg::kTileRays> kept;    ///< by request: the sample may be used elsewhere
    std::vector<GatherRay> pending;
    std::vector<std::uint32_t> order, before,
        start;                        ///< of those: their order, the one before, and where each key begins
    std::vector<std::uint16_t> keys;  ///< of those: which way they point
    csg::RayTile rays, shaded_rays;
    csg::HitTile hits, shaded_hits;
    std::array<std::uint8_t, csg::kTileRays> owner, shaded;  ///< by ray: request; by shaded ray: ray
    std::array<std::uint16_t, csg::kTileRays> number;        ///< by ray: which of the sample's
    std::array<scene::Color, csg::kTileRays> colors;
    std::vector<std::uint64_t> taken;                        ///< by place in the order of directions, a bit each
    alignas(64) std::array<double, csg::kTileRays> inverse;  ///< by ray: of how far off it hits
    std::size_t waiting = 0;                                 ///< of the shaded rays, until there is a tile of them
    std::array<std::uint8_t, csg::kTileRays> waiting_owner;  ///< by these: request
    std::array<float, csg::kTileRays> waiting_share;         ///< by these: importance of what they hit
};

}  // namespace trace::radiosity
