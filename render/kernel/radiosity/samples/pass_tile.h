#pragma once

#include "render/kernel/radiosity/samples/sample.h"

#include <array>
#include <vector>

namespace trace::radiosity {

/// Some rays of the camera whose hits ask for light (spec 6, 4.7).
struct PassTile {
    static constexpr std::size_t kMost = 64;
    std::array<glm::dvec2, kMost> at;  ///< of the picture: a pixel's centre is (column, row)
    int count = 0;
    std::uint64_t seed = 0;                           ///< of the directions of its samples
    bool pretrace = true;                             ///< false: by the rules of the picture itself
    const std::vector<std::size_t>* first = nullptr;  ///< by bounce: the directions it begins with; null: the seed says
};

/// What such a tile leaves.
struct TileFindings {
    std::vector<Found> found;
    int asked = 0;                  ///< hits that asked
    double weight = 0;              ///< quarters of weight that they have, added up
    std::vector<std::size_t> next;  ///< by bounce: the direction after those of its samples
};

}  // namespace trace::radiosity
