#pragma once

#include "render/kernel/surface/pigment_batch.h"
#include "render/kernel/surface/texture_maps.h"

#include <array>

namespace trace {

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
    bool alone;                    ///< PatternedLayers::alone
    HitMask mixed;                 ///< hits whose colour is a mixture of rows: nothing goes on from them
};

/// What SurfaceStage keeps per thread.
struct SurfaceScratch {
    PigmentBatch pigments;       ///< of the hits of one layer, then of layer after layer of the others
    texture::ColorPoints solid;  ///< one colour for all hits
    std::array<LayeredGroup, csg::kTileRays> layered;
    std::size_t layered_count = 0;
    TextureMaps maps;                                ///< of the tile at hand
    std::array<MappedGroup, csg::kTileRays> mapped;  ///< hits that have the same texture map
    std::size_t mapped_count = 0;
};

}  // namespace trace
