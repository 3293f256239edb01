#pragma once

#include "render/trace/media/media_density.h"
#include "render/trace/media/media_extinction.h"
#include "render/trace/media/pieces.h"

#include <array>
#include <cstdint>
#include <vector>

namespace trace {

/// A segment of the tile at hand that crosses media.
struct MediaSegment {
    csg::Ray ray;
    double length = 0;
    const MediaMix* mix = nullptr;
    std::uint8_t lane = 0;                    ///< its place in the tile
    std::uint32_t piece = 0, last_piece = 0;  ///< into MediaScratch::pieces: the one at hand, and one past the last
    int part = 0;                             ///< sub-intervals of the piece at hand that have been handed out
    std::uint32_t interval = 0;               ///< sub-intervals that have been handed out
    std::uint64_t seed = 0;                   ///< of its random numbers
    glm::vec3 depth{0}, glow{0};              ///< optical depth so far; what of the light reaches the origin
};

/// A sub-interval on its way.
struct MediaJob {
    MediaSegment* segment;
    std::uint32_t interval;  ///< its number in the segment
    double from, step;
    bool lit;
    bool even = false;                        ///< every sample tells the same: one is taken
    std::uint32_t first = 0;                  ///< of its samples in MediaScratch::order
    int gaps = 0;                             ///< of method 3
    int taken = 0;                            ///< samples so far
    glm::vec3 sum{0}, squares{0}, depths{0};  ///< of contributions, their squares, optical depths

    const plan::Media& control() const { return *segment->mix->control; }
};

/// Samples side by side: where on their sub-interval (0 to 1), and what was found there.
struct MediaSamples {
    std::vector<std::uint32_t> job;  ///< into MediaScratch::jobs
    std::vector<double> place;
    std::vector<glm::vec3> light, depth;  ///< e and o of spec 6, 2.6

    std::size_t size() const { return job.size(); }
    void clear() { job.clear(), place.clear(), light.clear(), depth.clear(); }
    std::uint32_t add(std::uint32_t of, double at)
    {
        job.push_back(of);
        place.push_back(at);
        return static_cast<std::uint32_t>(job.size() - 1);
    }
};

/// A gap between two samples of method 3, which its middle divides.
struct MediaGap {
    std::uint32_t first, last;                  ///< samples
    int level;                                  ///< it may be halved so often, not counting the first time
    std::uint32_t number;                       ///< of its middle among those of the sub-interval
    std::uint32_t middle = 0;                   ///< sample
    std::uint32_t left = kNone, right = kNone;  ///< halves that are divided again: gaps made later
    glm::vec3 light{0}, depth{0};
    static constexpr std::uint32_t kNone = 0xffffffffu;
};

/// Where a light reaches the segments of a tile.
struct LitSegments {
    HitMask reached = 0;  ///< by segment
    alignas(64) std::array<double, csg::kTileRays> from, to;
};

/// What media keep per thread; grows to what the scene needs and stays.
struct MediaScratch {
    std::vector<MediaMix> mixes;
    std::size_t mix_count = 0;
    std::vector<MediaSegment> segments;
    std::vector<LitSegments> lit;    ///< by light of the scene
    std::vector<MediaRange> ranges;  ///< of the segment at hand
    std::vector<MediaPiece> pieces;
    std::vector<MediaJob> jobs;
    MediaSamples samples;
    std::vector<std::uint32_t> order;  ///< samples of a job, the nearest first
    std::vector<MediaGap> gaps;
    std::vector<std::uint32_t> asking;  ///< sub-intervals that want one more sample
    texture::Points points;
    MediaDensity density;
    MediaShadows shadows;
    csg::HitTile met;  ///< how far each point lies from its ray's origin
};

}  // namespace trace
