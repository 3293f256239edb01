#pragma once

#include "csg/hit.h"
#include "render/light/illuminate.h"
#include "render/trace/flat_layers.h"
#include "render/trace/highlight_lanes.h"
#include "render/trace/pigment_batch.h"
#include "render/trace/shade_lanes.h"
#include "render/trace/surface_traits.h"
#include "render/trace/wave.h"

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

/// A layer of flat hits whose normals are still to be bent.
struct Bend {
    HitMask hits;
    std::uint32_t normal;
    std::uint8_t depth;
};

/// Hits of a tile that have the same texture of layers.
struct LayeredGroup {
    HitMask hits;
    std::uint32_t texture;
    bool flat;                   ///< AheadLayers::flat
};

/// Where the shadow rays of a tile's hits to the light at hand begin and end.
struct alignas(64) ShadowEnds {
    alignas(64) TileLanes from, to;
};

/// The nodes of the light at hand, for all hits of a tile at once; reused from light to light.
struct AreaScratch {
    struct Node {
        double row, column;
        HitMask known;               ///< hits whose light from here is in `value`
        TileColors value;
    };
    std::vector<Node> nodes;                 ///< those that some hit asked for
    std::vector<std::uint32_t> place;        ///< by i * size2 + j: index into `nodes`, or kNone
    std::vector<std::uint32_t> wanted;       ///< of `nodes`: asked for next
    static constexpr std::uint32_t kNone = 0xffffffffu;
};

/// What shading keeps per thread; grows to what the scene needs and stays.
struct ShadeScratch {
    SceneTraits traits;                  ///< filled by the first tile
    std::vector<LightSample> lights;     ///< a stack: every shaded hit owns lights.size() entries at its level
    std::vector<csg::Share> shares;      ///< a stack: of a blob's components, while their textures are shaded
    AreaScratch area;
    TileColors area_colors;              ///< of the area light at hand, past what shadows it
    std::vector<glm::vec3> area_nodes;   ///< shadow values of the area light at hand; red below 0: not yet known
    csg::RayTile rays;                   ///< shadow rays of a tile
    Wave wave;                           ///< rays that go on from the tile's hits
    std::array<WaitingRay, csg::kTileRays> waiting;   ///< those being traced
    csg::RayTile onward_rays;            ///< the same as a tile
    csg::HitTile onward_hits;
    TileHits hits;                       ///< of a tile
    TileLight light;                     ///< the one at hand
    ShadowEnds shadow_ends;              ///< the same
    std::array<glm::vec3, csg::kTileRays> lit_colors;   ///< of the light at hand, before shadows
    TileColors reaching;                 ///< colours of the light at hand where it reaches flat hits
    std::array<FlatDepth, kLayersAhead> flat;           ///< hits that go through the lights together
    texture::ColorPoints top_pigments;   ///< of flat hits that rays go on from
    texture::ColorPoints solid;          ///< one colour for all hits
    TileColors sums;                     ///< of flat hits, when the lights are through
    std::array<Bend, csg::kTileRays * kLayersAhead> bends;
    texture::Points points;              ///< of pattern space, by hit
    PigmentBatch pigments;               ///< of the flat hits of one layer, then of layer after layer of the others
    std::array<texture::Surroundings, csg::kTileRays> around;
    std::array<LayeredGroup, csg::kTileRays> layered;
    std::size_t layered_count = 0;
    ColorsAhead ahead;                   ///< pigments of the layers of those
    std::array<HitMask, kLayersAhead> asked;   ///< by depth: where they are
    csg::CrossingTile crossings;         ///< of the shadow rays; only how they end where nothing filters
    std::array<csg::HitDetails, csg::kTileRays> details;
    std::array<std::uint8_t, csg::kTileRays> lane;   ///< of each shadow ray: which hit it belongs to
};

}  // namespace trace
