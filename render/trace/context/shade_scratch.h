#pragma once

#include "csg/base/hit.h"
#include "render/light/illuminate.h"
#include "render/trace/tile/row_page.h"
#include "render/trace/tile/air.h"
#include "render/trace/gather/near_photons.h"
#include "render/trace/traits/photon_shadow.h"
#include "render/trace/interior/dispersion.h"
#include "render/trace/tile/pigment_batch.h"
#include "render/trace/tile/tile_lanes.h"
#include "render/trace/traits/surface_traits.h"
#include "render/trace/context/kept.h"
#include "render/trace/queue/ray_queue.h"

#include <array>
#include <memory>
#include <vector>

namespace trace {

class TextureMaps;

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

/// Hits of a tile that have the same texture of layers.
struct LayeredGroup {
    HitMask hits;
    std::uint32_t texture;
    bool alone;  ///< PatternedLayers::alone
};

/// The same of hits with a texture map.
struct MappedGroup {
    HitMask hits;
    std::uint32_t texture, place;  ///< place: as TextureMaps has looked it up
};

/// Where the shadow rays of a tile's hits to the light at hand begin and end.
struct alignas(64) ShadowEnds {
    alignas(64) TileLanes from, to;
};

/// The nodes of the area light at hand, for all hits of a tile at once; reused from light to light.
struct AreaScratch {
    std::vector<HitMask> known;        ///< by node that some hit asked for, as below: hits that have been told
    std::vector<HitMask> lit;          ///< of them, those that see it, through nothing
    std::vector<HitMask> mixed;        ///< of them, those that see it through something that filters light
    std::vector<TileColors> filtered;  ///< what reaches those; shorter than the others where nothing does
    std::vector<double> row, column;
    std::vector<glm::dvec3> at;         ///< where it lies on the light, if that is the same for all hits
    std::vector<std::uint32_t> place;   ///< by i * size2 + j: the node, or kNone
    std::vector<std::uint32_t> wanted;  ///< nodes asked for next
    struct Rectangle {
        int i1, j1, i2, j2, depth;  ///< corners; how often it was divided before
        HitMask hits;               ///< that ask for it
    };
    std::vector<Rectangle> level, next_level;
    static constexpr std::uint32_t kNone = 0xffffffffu;
};

/// A layer's mirror, remembered until all layers have been gone through.
struct Mirror {
    glm::vec3 reflectivity;
    glm::dvec3 normal;
    float weight;
    const texture::Finish* finish;
};

/// What a shadow ray crosses that begins anew behind each crossing (light/restarted_rays.h).
struct RestartedRay {
    std::vector<csg::Hit> crossings;  ///< by distance from where it began
    csg::Shadow ending = csg::Shadow::Clear;
};

struct RestartedScratch {
    std::array<RestartedRay, csg::kTileRays> rays;
    csg::RayTile tile;
    csg::HitTile hits;
};

/// Crossings of shadow rays with surfaces of patterns or `caustics`, and what they leave of light
/// (light/surface_filters.h).
struct FilterScratch {
    struct Place {
        std::uint8_t ray, crossing;
    };
    csg::RayTile rays;
    csg::HitTile hits;
    TileHits places;
    std::array<Place, csg::kTileRays> place;
    /// By shadow ray and crossing, where SurfaceTraits::filters_together.
    std::array<std::array<glm::vec3, csg::CrossingTile::kMost>, csg::kTileRays> filters;
};

/// What shading keeps per thread; grows to what the scene needs and stays.
struct ShadeScratch {
    SceneTraits traits;                ///< filled by the first tile
    std::vector<LightSample> samples;  ///< by hit and light, of hits with such rows
    std::vector<Mirror> mirrors;       ///< of the layers of the texture at hand
    std::vector<csg::Share> shares;    ///< of a blob's components
    AreaScratch area;
    TileColors area_colors;                          ///< of the area light at hand, past what shadows it
    csg::RayTile rays;                               ///< shadow rays of a tile
    RayQueue queue;                                  ///< rays that go on from the tile's hits
    std::array<QueuedRay, csg::kTileRays> segments;  ///< those being traced
    csg::RayTile segment_rays;                       ///< the same as a tile
    SpectrumPowers spectrum;                         ///< of light that has been dispersed
    csg::HitTile segment_hits;
    std::array<Air, csg::kTileRays> air;  ///< by segment, where there is some (AirStage)
    bool in_media = false;                ///< a ray of the queue may have been inside of media of an interior
    TileHits hits;                        ///< of a tile
    TileLight light;                      ///< the one at hand
    ShadowEnds shadow_ends;               ///< the same
    std::array<glm::vec3, csg::kTileRays> lit_colors;  ///< of the light at hand, before shadows
    TileColors reaching;                               ///< colours of the light at hand where it reaches hits
    std::vector<RowPage> pages;                        ///< rows that go through the lights together
    std::vector<ClosingNode> closing;                  ///< of the tile at hand
    texture::ColorPoints top_pigments;                 ///< of hits of one layer that rays go on from
    texture::ColorPoints solid;                        ///< one colour for all hits
    TileColors sums;                                   ///< of all rows, when the lights are through
    std::array<Bend, csg::kTileRays * kPrefetchedLayers> bends;
    texture::Points points;  ///< of pattern space, by hit
    PigmentBatch pigments;   ///< of the hits of one layer, then of layer after layer of the others
    std::array<texture::Surroundings, csg::kTileRays> around;
    std::array<LayeredGroup, csg::kTileRays> layered;
    std::size_t layered_count = 0;
    std::array<LayerPoints, kPrefetchedLayers> prefetched;  ///< by depth: pigments of the layers of those, and normals
                                                            ///< where rays go on from them
    Kept<TextureMaps> maps;                                 ///< of the tile at hand
    std::array<MappedGroup, csg::kTileRays> mapped;         ///< hits that have the same texture map
    std::size_t mapped_count = 0;
    std::array<HitMask, kPrefetchedLayers> asked;  ///< by depth: where they are
    std::array<float, csg::kTileRays> quality;     ///< of rays that gather: how far they were followed (spec 6, 4.3)
    csg::CrossingTile crossings;                   ///< of the shadow rays; only how they end where nothing filters
    std::array<csg::HitDetails, csg::kTileRays> details;
    std::unique_ptr<FilterScratch> filters;         ///< of the light at hand, in scenes that need it
    std::unique_ptr<RestartedScratch> restarted;    ///< of the light at hand, in scenes that need it
    PhotonShadow photon_shadow;                     ///< of the light at hand
    NearPhotons near_photons, wide_photons;         ///< around the hit at hand
    std::array<std::uint8_t, csg::kTileRays> lane;  ///< of each shadow ray: which hit it belongs to

    /// A ray goes into what has this interior, or out of it.
    void cross(const plan::Interior& interior)
    {
        if (traits.interior_media) in_media |= !interior.media.empty();
    }
};

}  // namespace trace
