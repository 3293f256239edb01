#include "render/plan/geometry/geometry.h"

#include <algorithm>
#include <bit>

/// What the surfaces of solids are drawn with: textures and interiors where they stand, shared by copies.
namespace plan {

csg::SurfaceId GeometryCompiler::surface(const Inherited& own, const std::array<PlacedTexture, 2>& corners,
                                         const std::vector<std::uint32_t>& parts)
{
    if (sharing_ != nullptr) return shared_surface(own, corners, !parts.empty());
    const PlacedTexture& texture = own.texture ? own.texture : default_texture_;
    Surface s;
    s.texture = textures_.texture(texture);
    s.interior_texture = own.interior_texture ? textures_.texture(own.interior_texture) : kNone;
    for (std::size_t k = 0; k < 2; ++k)
        if (corners[k]) s.corner_textures[k] = textures_.texture(corners[k]);
    if (!parts.empty()) {
        const auto [known, fresh] =
            known_parts_.try_emplace(parts, static_cast<std::uint32_t>(out_.part_textures.size()));
        if (fresh) out_.part_textures.insert(out_.part_textures.end(), parts.begin(), parts.end());
        s.first_part = known->second;
        s.part_count = static_cast<std::uint32_t>(parts.size());
    }
    s.interior = interior(own, texture);
    s.object = object_;
    s.no_shadow = own.no_shadow;
    s.no_image = own.no_image;
    s.no_reflection = own.no_reflection;
    s.double_illuminate = own.double_illuminate;
    if (has_radiosity(description_.global, options_.quality)) s.importance = own.importance.value_or(1.0f);
    s.uv_mapping = own.uv_mapping;
    s.opaque_outside = own.opaque_outside;
    s.light_group = own.light_group;
    s.global_lights = own.global_lights;
    s.photons = photon_surface(own);
    const std::uint32_t flags = (s.no_shadow ? 1u : 0u) | (s.no_image ? 2u : 0u) | (s.no_reflection ? 4u : 0u) |
                                (s.double_illuminate ? 8u : 0u) | (s.uv_mapping ? 16u : 0u) |
                                (s.global_lights ? 32u : 0u) | (s.opaque_outside ? 64u : 0u);
    const auto id = static_cast<csg::SurfaceId>(out_.surfaces.size());
    const auto [known, fresh] = known_surfaces_.try_emplace(
        {s.texture, s.interior_texture, s.interior, s.object, flags, s.corner_textures[0], s.corner_textures[1],
         parts.empty() ? kNone : s.first_part, s.light_group, std::bit_cast<std::uint32_t>(s.importance), s.photons},
        id);
    if (fresh) out_.surfaces.push_back(s);
    return known->second;
}

std::uint32_t GeometryCompiler::interior(const Inherited& own, const PlacedTexture& texture)
{
    if (!own.interior && !automatic_interior_) automatic_interior_ = interiors_.automatic();
    const std::uint32_t index = own.interior ? interiors_.interior(*own.interior, own.interior_copy)
                                             : *automatic_interior_;
    interiors_.take_finish(index, texture.texture.get());
    out_.interiors[index].hollow = own.hollow.value_or(false);  // the last one that shares it decides (spec 5a, 10.3)
    return index;
}

/// The same of an interior whose media differ from place to place; other interiors are their own.
std::shared_ptr<const scene::Interior> GeometryCompiler::moved(const std::shared_ptr<const scene::Interior>& interior,
                                                               const csg::Transform& to_world)
{
    const auto& media = interior->media;
    if (to_world.identity() ||
        std::none_of(media.begin(), media.end(), [](const auto& one) { return depends_on_place(*one); }))
        return interior;
    std::shared_ptr<const scene::Interior>& known = moved_interiors_(interior.get(), to_world).value;
    if (!known) {
        auto copy = std::make_shared<scene::Interior>(*interior);
        copy->transform(to_world);
        known = std::move(copy);
    }
    return known;
}

std::uint32_t GeometryCompiler::interior_copy(const scene::Interior& interior, const csg::Transform& to_world)
{
    std::optional<std::uint32_t>& known = interior_copies_(&interior, to_world).value;
    if (!known) known = interior_copy_count_++;
    return *known;
}

/// The texture in world space; equal for equal transformations, so that copies share it.
PlacedTexture GeometryCompiler::moved(const scene::TexturePtr& texture, const csg::Transform& to_world)
{
    if (!texture || to_world.identity() || texture->alike_everywhere()) return {texture};
    const PlacedTexture placed{texture, &places_(nullptr, to_world).at};
    if (sharing_ != nullptr) return {written_there(placed)};  // copies move it on
    return placed;
}

scene::TexturePtr GeometryCompiler::written_there(const PlacedTexture& placed)
{
    if (placed.by == nullptr) return placed.texture;
    scene::TexturePtr& known = written_[placed];
    if (!known) {
        auto copy = std::make_shared<scene::Texture>(*placed.texture);
        copy->transform(*placed.by);
        known = std::move(copy);
    }
    return known;
}

}  // namespace plan
