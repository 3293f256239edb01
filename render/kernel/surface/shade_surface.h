#pragma once

#include "render/kernel/context/context.h"
#include "render/kernel/scatter/scatter.h"

/// The textures of one hit.
namespace trace {

class DirectBatch;

/// Goes through all textures of a hit: their rows go to the batch, nodes and rays to the queue; its colour is to come
/// into `out`.
void shade_surface(Context& context, DirectBatch& batch, HitContext& hit, const HitDetails& details, ColorSlot out);

/// The same of one texture at p (its own space's point).
void shade_texture(Context& context, DirectBatch& batch, HitContext& hit, std::uint32_t texture, const glm::dvec3& p,
                   ColorSlot out);

/// The same of a plain texture: all layers (spec 3, section 6).
void shade_layers(Context& context, DirectBatch& batch, HitContext& hit, const texture::Texture& texture,
                  const glm::dvec3& p, ColorSlot out);

/// The layers of a plain texture at a hit without their light (photons). p: in the texture's space.
LayerStack layer_stack(Context& context, HitContext& hit, const texture::Texture& texture, const glm::dvec3& p);

}  // namespace trace
