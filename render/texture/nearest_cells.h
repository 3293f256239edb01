#pragma once

#include <glm/glm.hpp>

#include <array>

namespace texture {

/// The three nearest of the scattered points around `p`, one per unit cell (spec 4, 5.4).
struct NearestCells {
    std::array<double, 3> powered;   ///< sum of |delta|^metric, ascending
    glm::dvec3 point;                ///< the nearest
};

/// Searches the 81 cells about `base_cell`. `signed_sum`: metric 1 adds signed deltas (facets' defect).
NearestCells nearest_cells(const glm::dvec3& p, const glm::dvec3& base_cell, double metric, bool signed_sum);

}  // namespace texture
