#pragma once

#include "csg/base/types.h"

#include <cmath>

namespace csg {

/// Whether a linear map keeps spheres spheres; `factor` then tells by how much they grow.
inline bool keeps_spheres(const glm::dmat3& m, double& factor)
{
    constexpr double kFewRoundings = 1e-12;  // relative, squared lengths: a few roundings of products of rotations
    const glm::dmat3 square = glm::transpose(m) * m;
    factor = std::sqrt(square[0][0]);
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            if (!(std::abs(square[i][k] - (i == k ? square[0][0] : 0.0)) <= kFewRoundings * square[0][0])) return false;
    return true;
}

}  // namespace csg
