#pragma once

#include "render/trace/media/media_scratch.h"
#include "render/trace/queue/segment_tile.h"

namespace trace {

/// Colours of a medium's densities at points, multiplied; needs `points` padded. `colors` is for use within.
void media_density(const plan::CompiledScene& scene, const plan::Media& media, const texture::Points& points,
                   texture::ColorPoints& colors, TileColors& density);

/// Finds what samples of sub-intervals contribute (spec 6, 2.6), 64 at a time.
class MediaSampler {
public:
    MediaSampler(Context& context, MediaScratch& scratch, const SegmentTile& tile)
        : context_(context), scratch_(scratch), tile_(tile)
    {}

    /// Samples first, first + 1, ... to the last there is.
    void evaluate(std::size_t first);

private:
    void batch(std::size_t first, std::size_t last);
    void add_media(std::size_t count);
    void add_light(std::size_t first, std::size_t last, HitMask scattering);

    Context& context_;
    MediaScratch& scratch_;
    const SegmentTile& tile_;
    std::array<const MediaSegment*, csg::kTileRays> segments_;
    std::array<const MediaMix*, csg::kTileRays> mixes_;
    TileColors emission_, scattering_, extinction_;
};

}  // namespace trace
