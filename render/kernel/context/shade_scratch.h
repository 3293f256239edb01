#pragma once

#include "csg/base/hit.h"
#include "render/light/illuminate.h"
#include "render/kernel/tile/row_page.h"
#include "render/kernel/tile/air.h"
#include "render/kernel/gather/near_photons.h"
#include "render/kernel/context/photon_shadow.h"
#include "render/kernel/interior/dispersion.h"
#include "render/kernel/tile/layer_points.h"
#include "render/kernel/tile/tile_lanes.h"
#include "render/kernel/context/kept.h"
#include "render/kernel/queue/ray_queue.h"

#include <array>
#include <vector>

namespace trace {

struct AreaScratch;
class Recorder;
struct FilterScratch;
struct RestartedScratch;
struct SurfaceScratch;

/// One light at one hit, for the rows that go through the lights one by one (spec 3, 13.4).
struct LightSample {
    light::Illumination lit;
    glm::vec3 arriving;  ///< its colour past what shadows it
};

/// A node that waits for the light of rows `first` to `last` of a hit.
struct ClosingNode {
    std::uint32_t node;
    std::uint8_t hit;
    std::uint16_t first, last;
};

/// Rows whose normals are still to be bent.
struct Bend {
    HitMask hits;
    std::uint32_t normal;
    std::uint8_t depth;
};

/// Where the shadow rays of a tile's hits to the light at hand begin and end.
struct alignas(64) ShadowEnds {
    alignas(64) TileLanes from, to;
};

/// A layer's mirror, remembered until all layers have been gone through.
struct Mirror {
    glm::vec3 reflectivity;
    glm::dvec3 normal;
    float weight;
    const texture::Finish* finish;
};

/// Segments of the queue that are being traced: the driver's.
struct SegmentScratch {
    std::array<QueuedRay, csg::kTileRays> queued;
    csg::RayTile rays;  ///< the same as a tile
    csg::HitTile hits;
};

/// The surface stage's, for the light stage too, which bends normals: what textures are asked for at the tile's hits.
struct PatternScratch {
    texture::Points points;  ///< of pattern space, by hit
    std::array<texture::Surroundings, csg::kTileRays> around;
    std::array<LayerPoints, plan::kPrefetchedLayers> layers;  ///< by depth: pigments of layers of textures, and normals
                                                              ///< where rays go on from them
    std::array<HitMask, plan::kPrefetchedLayers> asked;       ///< by depth: where they are
};

/// Rows of the tile's hits: the surface stage fills them, the light stage and those of other light sum them up.
struct RowScratch {
    std::vector<RowPage> pages;         ///< rows that go through the lights together
    std::vector<LightSample> samples;   ///< by hit and light, of hits with rows that do not
    std::vector<ClosingNode> closing;   ///< of the tile at hand
    std::vector<HitMask> laid;          ///< by page: hits of DirectBatch::lay()
    texture::ColorPoints top_pigments;  ///< of hits of one layer that rays go on from
    TileColors sums;                    ///< of all rows, when the lights are through
    std::array<Bend, csg::kTileRays * plan::kPrefetchedLayers> bends;
};

/// The light at hand, as the light stage and media ask for it.
struct LampScratch {
    TileLight light;
    std::array<glm::vec3, csg::kTileRays> colors;  ///< before shadows
    TileColors reaching;                           ///< colours where it reaches hits
    TileColors shadowed;                           ///< of an area light: past what shadows it
    PhotonShadow photons;
};

/// Shadow rays of a tile to it.
struct ShadowScratch {
    csg::RayTile rays;
    std::array<std::uint8_t, csg::kTileRays> lane;  ///< of each ray: which hit it belongs to
    ShadowEnds ends;
    csg::CrossingTile crossings;  ///< only how they end where nothing filters
};

/// Photons around the point at hand.
struct PhotonScratch {
    NearPhotons near, wide;
};

/// What shading keeps per thread; grows to what the scene needs and stays.
struct ShadeScratch {
    RayQueue queue;  ///< rays that go on from the tile's hits
    SegmentScratch segments;
    TileHits hits;  ///< of the tile
    std::array<csg::HitDetails, csg::kTileRays> details;
    std::array<Air, csg::kTileRays> air;  ///< by segment, where there is some (AirStage)
    bool in_media = false;                ///< a ray of the queue may have been inside of media of an interior
    PatternScratch patterns;
    RowScratch rows;
    LampScratch lamp;
    ShadowScratch shadow;
    PhotonScratch photons;
    std::vector<Mirror> mirrors;                ///< of the layers of the texture at hand
    std::vector<csg::Share> shares;             ///< of a blob's components
    SpectrumPowers spectrum;                    ///< of light that has been dispersed
    std::array<float, csg::kTileRays> quality;  ///< of rays that gather: how far they were followed (spec 6, 4.3)

    // What one stage keeps for itself.
    Kept<SurfaceScratch, false> surface;
    Kept<AreaScratch> area;
    Kept<FilterScratch> filters;
    Kept<RestartedScratch> restarted;

    Recorder* recorder = nullptr;  ///< hears what stages do (record/recorder.h)
};

}  // namespace trace
