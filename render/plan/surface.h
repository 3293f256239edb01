#pragma once

#include "csg/base/types.h"

#include <array>
#include <cstdint>

namespace plan {

inline constexpr std::uint32_t kNone = 0xffffffffu;

/// What a csg::SurfaceId means: one entry per (texture, interior, flags, ...) combination in use.
/// Two leaves of one object share an entry; two objects never share an interior they did not share in the text.
struct Surface {
    std::uint32_t texture = kNone;  ///< index into TextureSet::textures; kNone: contributes black
    /// What the second and third corner of a mesh's face show, mixed with `texture` by nearness; kNone: `texture`
    /// alone.
    std::array<std::uint32_t, 2> corner_textures{kNone, kNone};
    /// Textures of the parts of a shape (a blob's components) in CompiledScene::part_textures, mixed by their shares.
    std::uint32_t first_part = 0, part_count = 0;
    std::uint32_t interior_texture = kNone;  ///< seen from inside; kNone: as from outside
    std::uint32_t interior = kNone;          ///< index into CompiledScene::interiors; identity decides refraction
    std::uint32_t object = kNone;            ///< top-level object after splitting unions, in order of declaration
    bool no_shadow = false, no_image = false, no_reflection = false, double_illuminate = false;
    float importance = 1;         ///< of radiosity rays that meet it, above 0 to 1 (spec 6, 4.4)
    bool opaque = true;           ///< a shadow ray may stop here: no light comes through (spec 3, 13.2)
    bool opaque_outside = false;  ///< of a mesh or blob that is opaque: in shadows `interior_texture` is not asked
    bool uv_mapping = false;
    std::uint32_t light_group = 0;  ///< the innermost light_group that it stands in; 0: none
    bool global_lights = true;      ///< lights outside of all groups reach it
    std::uint32_t photons = 0;      ///< index into PhotonPlan::surfaces, where the scene has one
    /// The texture of the side that a ray meets; kNone: contributes black. from_inside: the raw normal faces along the
    /// ray
    std::uint32_t texture_of(bool from_inside) const
    {
        return from_inside && interior_texture != kNone ? interior_texture : texture;
    }
    /// Where its patterns see a hit.
    glm::dvec3 pattern_point(const glm::dvec3& point, const glm::dvec2& uv) const
    {
        return uv_mapping ? glm::dvec3(uv, 0.0) : point;
    }
    bool blends() const { return corner_textures[0] != kNone || part_count != 0; }
};

/// Which kind of ray asks; objects hide from some (spec 3, 14).
enum class RayKind : std::uint8_t { Image, Reflection, Shadow, Photon, MirroredPhoton, Gather };

/// The bit of a kind of ray in csg::World's visibility masks.
constexpr std::uint8_t bit(RayKind kind) { return static_cast<std::uint8_t>(1u << static_cast<unsigned>(kind)); }

}  // namespace plan
