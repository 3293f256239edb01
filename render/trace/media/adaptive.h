#pragma once

#include "render/trace/media/media_chunk.h"

#include <utility>

namespace trace {

/// Half of a gap of method 3 that is divided again, at its middle.
struct MediaGap {
    std::uint32_t first, last;                  ///< samples
    int level;                                  ///< it may be halved so often, not counting the first time
    std::uint32_t number;                       ///< of its middle among those of the sub-interval
    std::uint32_t middle = 0;                   ///< sample
    std::uint32_t left = kNone, right = kNone;  ///< halves that are divided again: gaps made later
    glm::vec3 light{0}, depth{0};
    static constexpr std::uint32_t kNone = 0xffffffffu;
};

/// What method 3 keeps per thread.
struct AdaptiveScratch {
    std::vector<MediaGap> gaps;
    std::vector<std::uint32_t> left, right;  ///< by gap between even samples: its halves, or MediaGap::kNone
    std::vector<std::uint32_t> divided;      ///< gaps that have such a half
    MediaColors light, depth;                ///< by gap between even samples: means over it
};

class MediaSampler;

/// Method 3 over a chunk (spec 6, 2.7): even samples with gaps between them, which are halved where neighbours differ.
class AdaptiveSums {
public:
    AdaptiveSums(MediaChunk& chunk, MediaSamples& samples, AdaptiveScratch& scratch, MediaSampler& sampler)
        : chunk_(chunk), samples_(samples), scratch_(scratch), sampler_(sampler)
    {}

    static int gaps_of(const plan::Media& control);
    /// Of a sub-interval whose samples all tell the same: what it gives, and its optical depth.
    static void even(const MediaMix& mix, double step, glm::vec3& light, glm::vec3& depth);
    void run();

private:
    using GapFlags = std::array<std::uint32_t, MediaChunk::kMost>;

    std::pair<std::uint8_t*, double*> add_samples();
    void place_even();
    void place_middles();
    void find_gaps();
    void find_steps(std::size_t n, GapFlags& left, GapFlags& right) const;
    void find_divided();
    void divide_all();
    void fold();
    void sum();
    void sum_undimmed();
    double middle_of(std::uint32_t first, std::uint32_t last, std::size_t job, std::uint32_t number) const;

    MediaChunk& chunk_;
    MediaSamples& samples_;
    AdaptiveScratch& scratch_;
    MediaSampler& sampler_;
    bool dims_ = true;                               ///< false: no medium takes light, and no depth is looked at
    std::size_t jobs_ = 0, gaps_ = 0, middles_ = 0;  ///< middles_: the first of those samples
    alignas(64) std::array<float, MediaChunk::kMost> threshold_;  ///< of the sub-intervals, if gaps may be divided
};

}  // namespace trace
