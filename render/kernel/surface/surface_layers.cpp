#include "render/texture/finish.h"
#include "render/kernel/interior/interface.h"
#include "render/kernel/light/direct_batch.h"
#include "render/kernel/scatter/refraction.h"
#include "render/kernel/scatter/scatter.h"
#include "render/kernel/surface/shade_surface.h"

#include <algorithm>
#include <cmath>

namespace trace {
namespace {

/// The layer's normal. layer: its place in the texture.
[[gnu::always_inline]] inline glm::dvec3 layer_normal(Context& context, HitContext& hit, std::uint32_t normal,
                                                      std::uint32_t layer, const glm::dvec3& p)
{
    if (normal == texture::kNone) return hit.normal;
    if (hit.prefetched != nullptr && hit.prefetched->bent) return hit.prefetched->normal(layer);
    return texture::bent_normal(context.scene.textures, normal, hit.normal, p, hit.around, hit.enclosing);
}

/// The pigment of a texture's i-th layer.
scene::Color pigment_of(const Context& context, const HitContext& hit, const texture::Texture& texture, std::uint32_t i,
                        const glm::dvec3& p)
{
    if (hit.prefetched != nullptr) return hit.prefetched->of(i);
    const auto& set = context.scene.textures;
    return texture::pigment_color(set, set.layers[texture.first + i].pigment, p, hit.around);
}

/// What is left of what the finish emits.
float glow_share(const Context& context, const HitContext& hit, const texture::Finish& finish, const glm::dvec3& normal)
{
    if (finish.own_fresnel == 0.0f) return 1.0f;
    const double eta = fresnel_index(context.scene.interiors, hit.state.interiors, hit.surface.interior);
    return static_cast<float>(texture::seen_share(finish, hit.state.ray.direction, normal, eta));
}

/// A row of light for the layer, and what it leaves to those below. Its pigment.
/// batch: null where no light is asked for.
[[gnu::always_inline]] inline scene::Color add_layer(Context& context, DirectBatch* batch, HitContext& hit,
                                                     const texture::Texture& texture, std::uint32_t index,
                                                     const glm::dvec3& p, LayerStack& stack)
{
    const auto& set = context.scene.textures;
    const texture::Layer& layer = set.layers[texture.first + index];
    const texture::Finish& finish = set.finishes[layer.finish];
    const glm::dvec3 normal = layer_normal(context, hit, layer.normal, index, p);
    if (stack.mirrors.empty()) stack.top_normal = normal;
    const scene::Color c = pigment_of(context, hit, texture, index, p);
    Mirror& mirror = stack.mirrors.emplace_back();
    if (!context.scene.settings.quality.lights) {
        mirror = {glm::vec3(0), normal, 0.0f, &finish};
    } else {
        find_mirror(context, hit, finish, c, normal, stack.residual, mirror);
        const float alpha = texture.plain ? 1.0f : texture::opacity(c, set.legacy_opacity);
        if (batch != nullptr)
            batch->add_row(hit.lane, {finish, c, stack.filter, alpha, glow_share(context, hit, finish, normal), normal,
                                      hit.normal, hit.surface.double_illuminate});
    }
    stack.pass(c, finish, mirror.reflectivity);
    return c;
}

}  // namespace

void shade_layers(Context& context, DirectBatch& batch, HitContext& hit, const texture::Texture& texture,
                  const glm::dvec3& p, ColorSlot out)
{
    const plan::Settings& settings = context.scene.settings;
    const auto bailout = static_cast<float>(context.adc_bailout);
    LayerStack stack(context.scratch.shade.mirrors);
    const std::uint32_t first = batch.rows(hit.lane);
    glm::vec3 plain_color(0);  // of a quality without lights: the lowest layer that shows
    for (std::uint32_t i = texture.count; i-- > 0 && stack.residual > bailout;) {
        const scene::Color c = add_layer(context, &batch, hit, texture, i, p, stack);
        if (!settings.quality.lights) plain_color = c.rgb();
    }
    const std::uint32_t node = scatter(context, hit, stack, out);
    context.scratch.shade.queue.nodes[node].own = plain_color;
    batch.close_node(hit.lane, first, node);
}

LayerStack layer_stack(Context& context, HitContext& hit, const texture::Texture& texture, const glm::dvec3& p)
{
    const auto bailout = static_cast<float>(context.scene.settings.adc_bailout);
    LayerStack stack(context.scratch.shade.mirrors);
    for (std::uint32_t i = texture.count; i-- > 0 && stack.residual > bailout;)
        add_layer(context, nullptr, hit, texture, i, p, stack);
    return stack;
}

}  // namespace trace
