#pragma once

#include "render/kernel/media/lit_ranges.h"
#include "render/kernel/extinction/media_mix.h"

#include <vector>

namespace trace {

/// Part of a segment that is cut into equal sub-intervals.
struct MediaPiece {
    double from, step;  ///< where it begins; length of a sub-interval
    int count;          ///< of sub-intervals
    bool lit;           ///< some light may reach it
};

/// Cuts a segment where its light begins and ends, and those parts into sub-intervals (spec 6, 2.4 and 2.5).
/// \param ranges  of the lights that may reach it; put in another order
/// \param out     what the pieces are added to
void add_pieces(const MediaMix& mix, double length, std::vector<MediaRange>& ranges, std::vector<MediaPiece>& out);

}  // namespace trace
