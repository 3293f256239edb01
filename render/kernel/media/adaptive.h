#pragma once

#include "render/kernel/media/media_chunk.h"

#include <utility>

namespace trace {

/// A mean over half of a gap, its fourth number unused: one vector.
struct alignas(16) MediaMean {
    float red, green, blue, none;
};

/// Gaps of method 3 that are halved again, those of one depth behind each other; those between even samples come first.
struct MediaGaps {
    std::size_t count = 0;
    std::vector<std::uint32_t> first, last;  ///< samples
    std::vector<std::uint32_t> owner;        ///< the half that it tells more of: 2 times its gap, + 1 the farther one
    std::vector<std::uint32_t> number;       ///< of its middle among those of the sub-interval; where that is drawn
    std::vector<MediaMean> half_light, half_depth;  ///< two of each

    void clear() { count = 0; }
    /// Room for so many more and one; it stays, whatever count is.
    void reserve(std::size_t more)
    {
        const std::size_t all = count + more + 1;
        if (first.size() >= all) return;
        first.resize(2 * all), last.resize(2 * all), owner.resize(2 * all), number.resize(2 * all);
        half_light.resize(4 * all), half_depth.resize(4 * all);
    }
};

/// What method 3 keeps per thread.
struct AdaptiveScratch {
    MediaGaps gaps;
    MediaColors light, depth;  ///< by gap between even samples: means over it
};

class MediaSampler;

/// Method 3 over a chunk (spec 6, 2.7): even samples with gaps between them, which are halved where neighbours differ.
class AdaptiveSums {
public:
    AdaptiveSums(MediaChunk& chunk, MediaSamples& samples, AdaptiveScratch& scratch, MediaSampler& sampler)
        : chunk_(chunk), samples_(samples), scratch_(scratch), sampler_(sampler)
    {}

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
    template <class Middle>
    void halve(std::size_t first, std::size_t end, bool again, Middle&& middle_of_gap);
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
    std::size_t divided_ = 0;                        ///< gaps between even samples that are halved
    alignas(64) std::array<float, MediaChunk::kMost> threshold_;  ///< of the sub-intervals, if gaps may be divided
};

}  // namespace trace
