#include "render/kernel/light/direct_batch.h"
#include "render/kernel/context/side_textures.h"
#include "render/kernel/record/recorder.h"
#include "render/kernel/surface/mix_textures.h"
#include "render/kernel/surface/shade_surface.h"

namespace trace {

void shade_texture(Context& context, DirectBatch& batch, HitContext& hit, std::uint32_t index, const glm::dvec3& p,
                   ColorSlot out)
{
    const auto& set = context.scene.textures;
    const texture::Shown shown = texture::shown_at(set, index, p, hit.around, hit.enclosing);
    using TextureKind = texture::Texture::Kind;
    if (shown.texture.kind == TextureKind::Layers)
        return shade_layers(context, batch, hit, shown.texture, shown.p, out);
    const auto shade = [&](std::uint32_t entry, ColorSlot slot) {
        shade_texture(context, batch, hit, set.children[entry], shown.p, slot);
    };
    if (shown.texture.kind == TextureKind::Average) average_textures(context, shown.texture, out, shade);
    else mix_textures(context, shown.blend, out, shade);
}

void shade_surface(Context& context, DirectBatch& batch, HitContext& hit, const HitDetails& details, ColorSlot out)
{
    const glm::dvec3 p = hit.surface.pattern_point(details.point, details.uv);
    const SideTextures shown(context.scene, context.world, hit.met, details, hit.from_inside,
                             context.scratch.shade.shares);
    if (!shown.mixed()) return shade_texture(context, batch, hit, shown.texture(0), p, out);
    // What weighs less than adc_bailout is left out, the rest as it is (spec 5b, 3.5).
    WeightedNode node(context, ShadeNode::Kind::Sum, shown.size(), out);
    for (std::size_t k = 0; k < shown.size(); ++k) {
        const float share = shown.share(k);
        if (static_cast<double>(share) < context.adc_bailout) continue;
        hit.enclosing.leave_all();
        const ColorSlot slot = node.slot_of(k, share);
        tell<&Recorder::entry>(context.scratch.shade, slot, shown.number(k), false);
        shade_texture(context, batch, hit, shown.texture(k), p, slot);
    }
}

}  // namespace trace
