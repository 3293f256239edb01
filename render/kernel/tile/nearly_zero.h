#pragma once

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

/// What counts as nothing.
namespace trace {

inline constexpr double kNearlyZero = 1e-10;  ///< light and index differences below it count as none
inline constexpr float kDark = 1e-10f;        ///< kNearlyZero for colours

/// Whether no channel of a light counts; NaN counts as dark.
inline bool dark(const glm::vec3& c)
{
    return !(std::abs(c.x) > kDark || std::abs(c.y) > kDark || std::abs(c.z) > kDark);
}
inline bool black(const glm::vec3& c) { return c.x == 0.0f && c.y == 0.0f && c.z == 0.0f; }
inline float largest(const glm::vec3& c) { return std::max({c.x, c.y, c.z}); }

}  // namespace trace
