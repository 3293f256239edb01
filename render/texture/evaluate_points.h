#pragma once

#include "render/texture/evaluate.h"
#include "render/texture/points/points.h"

#include <span>

/// Patterns and pigments of many points at once: the bits are those of evaluate.h for each point, but noise, sums of
/// octaves and crackle share vector lanes. Points that a function takes are padded (Points::pad).
namespace texture {

/// What surrounds each point.
using Around = std::array<const Surroundings*, kMostPoints>;

/// warp_point of each. `live`: components that are asked for (bit 0: x); classic turbulence leaves the others as they
/// were. Padded.
void warp_points(const TextureSet& set, const Pattern& pattern, Points& p, unsigned live);

/// pattern_value of each warped point.
void pattern_values(const TextureSet& set, const Pattern& pattern, const Points& p, const Around& around, Values& out);

/// perturb of each normal at its point; no pattern looks at normals that others have bent: what perturb leaves in the
/// surroundings is lost. Both padded.
void perturb_points(const TextureSet& set, std::uint32_t normal, const Points& p, const Around& around, Points& n);

/// normal_into() and normal_out_of() of each. Padded.
void normals_into(const TextureSet& set, const Pattern& pattern, bool keep_length, Points& n);
void normals_out_of(const TextureSet& set, const Pattern& pattern, bool keep_length, Points& n);

/// normal_out_of() of each in the spaces of these textures' patterns, the last one first: those of normal i are the
/// first reached[i], which are no fewer than those of the normal before. Padded, `reached` too.
void normals_out_of(const TextureSet& set, std::span<const std::uint32_t> textures, const Values& reached, Points& n);

/// glm::normalize of each. Padded.
void normalize_points(Points& n);

/// pigment_color of each point; p.count colours are written.
void pigment_colors(const TextureSet& set, std::uint32_t pigment, const Points& p, const Around& around,
                    ColorPoints& out);

}  // namespace texture
