#pragma once

#include "render/texture/evaluate.h"
#include "render/texture/points/points.h"

/// Values of many points after their wave, and looked up in maps, in vector lanes: the bits of evaluate.h.
namespace texture {

/// waved() of each value; `values` has room for whole vectors behind the last one.
void waved_points(const Pattern& pattern, std::size_t count, Values& values);

/// Blend of each point, its parts apart: entries of a map, counted from its first, and the share of the upper one.
struct BlendPoints {
    alignas(64) std::array<std::uint32_t, kMostPoints> lower, upper;
    Values share;
};
/// blend_at() of each value in a map of entries first to first + entries.
void map_blends(const TextureSet& set, std::uint32_t first, std::uint32_t entries, const Values& values,
                std::size_t count, BlendPoints& out);

/// The colours that a map of colours has at the values that points have.
void color_map_points(const TextureSet& set, const Pigment& map, const Values& values, const Points& points,
                      ColorPoints& out);

}  // namespace texture
