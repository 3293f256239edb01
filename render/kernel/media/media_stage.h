#pragma once

#include "render/kernel/extinction/even_fog.h"
#include "render/kernel/media/media_sampler.h"

/// Media over the segments of a tile (spec 6, 2).
namespace trace {

class MediaStage {
public:
    MediaStage(Context& context, const SegmentTile& tile);

    /// Media of what the rays are inside of, for segments that have met something.
    void cross_interiors(HitMask segments) { cross(segments, false); }
    /// Media of the whole scene.
    void cross_atmosphere(HitMask segments) { cross(segments, true); }

private:
    void cross(HitMask segments, bool atmosphere);
    const MediaMix* mix_of(std::size_t k, bool atmosphere);
    const MediaMix* find_mix(std::size_t k, bool atmosphere);
    void add_segment(std::size_t k, const MediaMix& mix);
    void find_lit(const MediaSegment& segment);
    bool take_parts();
    void take_part(std::size_t segment);
    bool is_even(const MediaMix& mix, bool lit) const;
    void work_off();
    void compose();

    Context& context_;
    ShadeScratch& shade_;
    MediaScratch& scratch_;
    const SegmentTile& tile_;
    MediaSampler sampler_;
    const InteriorList* last_inside_ = nullptr;  ///< of the segment looked at last; null: of none
    const MediaMix* last_mix_ = nullptr;         ///< its media
    std::size_t next_ = 0;                       ///< segment whose turn it is
    std::size_t ended_ = 0;                      ///< segments in a row that had nothing left
};

}  // namespace trace
