#pragma once

#include "render/kernel/media/media_scratch.h"
#include "render/kernel/context/segment_tile.h"

namespace trace {

/// Finds what samples of a chunk's sub-intervals contribute (spec 6, 2.6), 64 at a time.
class MediaSampler {
public:
    MediaSampler(Context& context, MediaScratch& scratch, const SegmentTile& tile)
        : context_(context), scratch_(scratch), tile_(tile)
    {}

    /// Samples first, first + 1, ... to the last there is.
    void evaluate(std::size_t first);

private:
    void batch(std::size_t first, std::size_t count);
    void place(std::size_t first, std::size_t count);
    void add_media();
    void add_light();
    void add_lamps(HitMask lit);
    void dim(std::size_t first, std::size_t count);
    void keep(std::size_t first, std::size_t count);
    const MediaJob& job(std::size_t k) const { return scratch_.chunk.jobs[job_[k]]; }

    Context& context_;
    MediaScratch& scratch_;
    const SegmentTile& tile_;
    const std::uint8_t* job_ = nullptr;  ///< of each sample of the batch at hand
    HitMask all_ = 0;
    bool one_mix_ = true;  ///< all points of the batch are of the same media
    TileColors emission_, scattered_, extinction_;
    alignas(64) TileFloats step_;  ///< length of the sub-interval
};

}  // namespace trace
