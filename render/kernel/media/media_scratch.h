#pragma once

#include "render/kernel/media/adaptive.h"
#include "render/kernel/extinction/media_extinction.h"
#include "render/kernel/media/pieces.h"

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

/// A sub-interval that has been handed out.
struct MediaPart {
    std::uint8_t segment;
    std::uint8_t job;  ///< in the chunk, or kEven
    double step;
    static constexpr std::uint8_t kEven = 0xff;  ///< alike everywhere: it needs no samples

    MediaPart(std::uint8_t of, std::uint8_t in_chunk, double length) : segment(of), job(in_chunk), step(length) {}
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
    std::vector<MediaPart> parts;
    MediaChunk chunk;
    MediaSamples samples;
    AdaptiveScratch adaptive;
    std::vector<std::uint32_t> asking;  ///< sub-intervals that want one more sample
    texture::Points points;
    MediaDensity density;
    csg::HitTile met;  ///< how far each point lies from its ray's origin
};

}  // namespace trace
