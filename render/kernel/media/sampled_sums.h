#pragma once

#include "render/kernel/media/media_chunk.h"

namespace trace {

class MediaSampler;

/// Methods 1 and 2 over a chunk (spec 6, 2.7): samples at random or evenly spaced, then more at random where their
/// variance is too large.
class SampledSums {
public:
    /// asking: for use within
    SampledSums(MediaChunk& chunk, MediaSamples& samples, std::vector<std::uint32_t>& asking, MediaSampler& sampler)
        : chunk_(chunk), samples_(samples), asking_(asking), sampler_(sampler)
    {}

    void run();

private:
    void place_least();
    void add(std::size_t i, std::size_t sample);
    bool uncertain(std::size_t i) const;

    MediaChunk& chunk_;
    MediaSamples& samples_;
    std::vector<std::uint32_t>& asking_;
    MediaSampler& sampler_;
    std::array<glm::vec3, MediaChunk::kMost> squares_;
};

}  // namespace trace
