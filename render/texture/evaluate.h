#pragma once

#include "render/texture/texture_set.h"

/// Values of patterns, pigments and normals at a point. Pure functions of the set and the point; no allocation.
namespace texture {

/// What a pattern may ask beyond its point: slope and aoi read it, uv_mapping takes `uv`.
struct Surroundings {
    glm::dvec3 point{0};      ///< the hit, world space
    glm::dvec3 normal{0};     ///< current normal of the hit (spec 4, 15.1); unit
    glm::dvec3 direction{0};  ///< of the ray, unit
    glm::dvec2 uv{0};
    bool surface = false;  ///< false for skies: slope and aoi give 0
};

/// `p` after the pattern's warps and classic turbulence (spec 4, section 8), components within +-1e17.
glm::dvec3 warp_point(const TextureSet& set, const Pattern& pattern, const glm::dvec3& p);

/// Value before frequency and wave at a warped point (spec 4, section 5).
double raw_pattern(const TextureSet& set, const Pattern& pattern, const glm::dvec3& p, const Surroundings& around);

/// Value after frequency, phase and wave form at a warped point (spec 4, section 4).
double pattern_value(const TextureSet& set, const Pattern& pattern, const glm::dvec3& p, const Surroundings& around);

/// Values are folded by it; it keeps an exact 1 from wrapping to 0 (spec 4, section 4).
inline constexpr double kModulus = 1.00001;

/// A raw value after frequency, phase and wave form.
double waved(const Pattern& pattern, double raw);

/// Two neighbouring entries of a map and the share of the upper one; lower == upper: that entry alone.
struct Blend {
    std::uint32_t lower = 0, upper = 0;  ///< indices into keys
    double share = 0;
};

/// Looks a value up (spec 4, 9.1). count >= 1.
Blend blend_at(const TextureSet& set, std::uint32_t first, std::uint32_t count, double value);

/// Per component: differences single, product with the double share rounded, sum single (spec 4, 9.2).
scene::Color mix(const scene::Color& lower, const scene::Color& upper, double share);

/// The same by what a map says of it; `working`: the curve that colours are levels of (spec 7b, 9).
scene::Color mix(const image::TransferCurve& working, const scene::Blending& blending, const scene::Color& lower,
                 const scene::Color& upper, double share);
/// What a map of colours has there.
scene::Color mapped(const TextureSet& set, const scene::Blending& blending, const Blend& at);

/// Sums of an average: weighted colours are added, then divided by the sum of the weights; single precision.
void add_weighted(scene::Color& sum, float weight, const scene::Color& c);
scene::Color divided(const scene::Color& sum, float weights);

scene::Color pigment_color(const TextureSet& set, std::uint32_t pigment, const glm::dvec3& p,
                           const Surroundings& around);

/// Whether the pigment is a picture that is not at `p`: then its colour is clear, and light passes the layer unchanged.
/// The layer's highlights and mirroring stay (spec 4, 11).
bool pigment_missing(const TextureSet& set, std::uint32_t pigment, const glm::dvec3& p, const Surroundings& around);

/// The texture of a material_map that a point of pattern space shows (spec 4, 12.8).
std::uint32_t material_at(const TextureSet& set, const Texture& texture, const glm::dvec3& p);

/// Bends `n` (faces the viewer) as the normal says (spec 4, section 15). Unit length. `around.normal` takes the result.
glm::dvec3 perturb(const TextureSet& set, std::uint32_t normal, const glm::dvec3& n, const glm::dvec3& p,
                   Surroundings& around);

/// The normal carried into and out of the space of a pattern by its transformations alone (spec 4, 15.1).
glm::dvec3 normal_into(const TextureSet& set, const Pattern& pattern, glm::dvec3 n, bool keep_length);
glm::dvec3 normal_out_of(const TextureSet& set, const Pattern& pattern, glm::dvec3 n, bool keep_length);

}  // namespace texture
