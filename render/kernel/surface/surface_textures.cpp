#include "render/kernel/light/direct_batch.h"
#include "render/kernel/surface/mix_textures.h"
#include "render/kernel/surface/shade_surface.h"

#include <cmath>

namespace trace {

namespace {

void average(Context& context, DirectBatch& batch, HitContext& hit, const texture::Texture& texture,
             const glm::dvec3& p, ColorSlot out)
{
    average_textures(context, texture, out, [&](std::uint32_t entry, ColorSlot slot) {
        shade_texture(context, batch, hit, context.scene.textures.children[entry], p, slot);
    });
}

/// The textures of a face's three corners. What weighs less than adc_bailout is left out, the rest as it is (spec
/// 5b, 3.5).
void corner_blend(Context& context, DirectBatch& batch, HitContext& hit, const glm::vec3& weights, const glm::dvec3& p,
                  ColorSlot out)
{
    const plan::Surface& surface = hit.surface;
    const std::array<std::uint32_t, 3> textures{surface.texture, surface.corner_textures[0],
                                                surface.corner_textures[1]};
    WeightedNode node(context, ShadeNode::Kind::Sum, textures.size(), out);
    for (std::size_t k = 0; k < textures.size(); ++k) {
        const float w = weights[static_cast<int>(k)];
        if (static_cast<double>(w) < context.adc_bailout) continue;
        hit.enclosing_count = 0;
        shade_texture(context, batch, hit, textures[k], p, node.slot_of(k, w));
    }
}

/// The textures of a shape's parts by their shares of the point, left out below adc_bailout like a mesh's.
void part_blend(Context& context, DirectBatch& batch, HitContext& hit, const glm::dvec3& p, ColorSlot out)
{
    auto& shares = context.scratch.shade.shares;
    shares.clear();
    context.world.shares(hit.met, hit.point, shares);
    WeightedNode node(context, ShadeNode::Kind::Sum, shares.size(), out);
    for (std::size_t k = 0; k < shares.size(); ++k) {
        const csg::Share share = shares[k];
        if (static_cast<double>(share.weight) < context.adc_bailout) continue;
        hit.enclosing_count = 0;
        shade_texture(context, batch, hit, context.scene.part_textures[hit.surface.first_part + share.part], p,
                      node.slot_of(k, share.weight));
    }
}

}  // namespace

void shade_texture(Context& context, DirectBatch& batch, HitContext& hit, std::uint32_t index, const glm::dvec3& p,
                   ColorSlot out)
{
    const auto& set = context.scene.textures;
    const texture::Texture& texture = set.textures[index];
    if (texture.kind == texture::Texture::Kind::Layers) return shade_layers(context, batch, hit, texture, p, out);
    if (texture.kind == texture::Texture::Kind::Uv) {
        // Transformations around a uv_mapping item move its normals, not its points (spec 4, 13).
        enclose(hit, index);
        const glm::dvec3 uv{hit.around.uv.x, hit.around.uv.y, 0.0};
        return shade_texture(context, batch, hit, set.children[texture.first], uv, out);
    }
    const texture::Pattern& pattern = set.patterns[texture.pattern];
    const glm::dvec3 q = texture::warp_point(set, pattern, p);
    enclose(hit, index);
    if (texture.kind == texture::Texture::Kind::Average) return average(context, batch, hit, texture, q, out);
    if (texture.kind == texture::Texture::Kind::Material)
        return shade_texture(context, batch, hit, texture::material_at(set, texture, q), q, out);
    const double v = texture::pattern_value(set, pattern, q, hit.around);
    const texture::Blend blend = texture::blend_at(set, texture.first, texture.count, v);
    mix_textures(context, blend, out, [&](std::uint32_t entry, ColorSlot slot) {
        shade_texture(context, batch, hit, set.children[entry], q, slot);
    });
}

void shade_surface(Context& context, DirectBatch& batch, HitContext& hit, const HitDetails& details,
                   std::uint32_t texture, ColorSlot out)
{
    const plan::Surface& surface = hit.surface;
    const glm::dvec3 p = surface.uv_mapping ? glm::dvec3(details.uv.x, details.uv.y, 0.0) : details.point;
    if (surface.part_count != 0) return part_blend(context, batch, hit, p, out);
    if (surface.blends() && texture == surface.texture)
        return corner_blend(context, batch, hit, details.weights, p, out);
    shade_texture(context, batch, hit, texture, p, out);
}

}  // namespace trace
