#pragma once

#include "csg/base/types.h"
#include "render/scene/textures/texture.h"

#include <array>
#include <cstdint>

/// A pattern, its warps and its wave as flat data; evaluation in evaluate.h.
namespace texture {

inline constexpr std::uint32_t kNone = 0xffffffffu;

/// Every pattern that is evaluated. `Average`, `Uv` and `Facets` are not functions of a point: the user of the map
/// handles them.
enum class PatternKind : std::uint8_t {
    Average,
    UserDefined,
    Uv,
#define PATTERN(keyword, enumerator, value) enumerator,
#include "render/texture/pattern_table.inc"
#undef PATTERN
    Facets,
};

/// world -> pattern space: p' = linear * p + offset, the inverse of what the author wrote.
struct Affine {
    glm::dmat3 linear{1.0};
    glm::dvec3 offset{0.0};
    glm::dmat3 normal_into{1.0};  ///< normals into pattern space: the transpose of what the author wrote
};

using Warp = std::variant<Affine, scene::Turbulence, scene::RepeatWarp, scene::BlackHoleWarp, scene::MappingWarp>;

/// One pattern with its modifiers. Plain data: `warps` and `pigment` are indices into the TextureSet.
struct Pattern {
    PatternKind kind = PatternKind::Checker;
    std::uint8_t noise_generator = 2;  ///< 1, 2 or 3: the scene's is filled in
    scene::WaveForm wave = scene::WaveForm::Ramp;
    bool has_turbulence = false;  ///< classic turbulence present (marble, wood, agate, spirals ask)
    bool displaces = false;       ///< classic turbulence moves the point before the formula
    bool folds = true;            ///< frequency is not 0 (spec 4, section 4 step 3)
    std::uint32_t first_warp = 0, warp_count = 0;
    std::uint32_t pigment = kNone;   ///< PigmentPattern: whose grey is the value
    std::uint32_t function = kNone;  ///< Function: index into TextureSet::functions
    std::uint32_t data = kNone;      ///< index into TextureSet's images, volumes or objects by kind
    double frequency = 1, phase = 0, poly_exponent = 1;
    scene::Turbulence turbulence;
    glm::dvec3 vector{0};             ///< gradient axis (unit), brick size, crackle form, julia's constant, ...
    std::array<double, 8> numbers{};  ///< by kind, see patterns/*.h
};

}  // namespace texture
