#pragma once

#include "render/texture/evaluate.h"

#include <array>

/// What one point and many share. Normals bent by heights: the places where a pattern is asked and what its values
/// weigh (spec 4, 15.1 and 15.6).
namespace texture {

/// A normal bent by facets (spec 4, 15.3).
glm::dvec3 facet_normal(const Pattern& pattern, const glm::dvec3& raw, const glm::dvec3& p);

/// A tetrahedron about the point; nine digits as POV-Ray has them.
inline constexpr std::array<glm::dvec3, 4> kHeightCorners{glm::dvec3{0.942809041, -0.333333333, 0},
                                                          {-0.471404521, -0.333333333, 0.816496581},
                                                          {-0.471404521, -0.333333333, -0.816496581},
                                                          {0, 1, 0}};

/// By how much a height of 1 at a corner moves the normal along it.
inline double height_strength(const Normal& normal) { return -5.0 * normal.amount * 0.02 / normal.accuracy; }

/// Height at v of a slope_map: cubic with the given slopes, flat outside the keys.
inline double slope_height(const TextureSet& set, const Normal& normal, double v)
{
    const Blend b = blend_at(set, normal.first, normal.count, v);
    const glm::dvec2 lower = set.slopes[b.lower], upper = set.slopes[b.upper];
    if (b.lower == b.upper) return lower.x;
    const double t = b.share, h0 = lower.x, s0 = lower.y, h1 = upper.x, s1 = upper.y;
    return t * t * t * (s0 + s1 + 2.0 * (h0 - h1)) - t * t * (2.0 * s0 + s1 + 3.0 * (h0 - h1)) + t * s0 + h0;
}

}  // namespace texture
