#pragma once

#include "render/kernel/context/side_textures.h"
#include "render/kernel/path/bsdf.h"
#include "render/kernel/scatter/refraction.h"

/// Evaluates a hit's textures to its BSDF and emission.
namespace trace::path {

/// A hit as a path needs it.
struct SurfaceLight {
    Bsdf bsdf;
    glm::vec3 emission{0};  ///< radiance towards the ray
    bool passes = false;    ///< light goes on behind it as `through`, if it is not of total reflection
    Refracted through;
    glm::dvec3 normal{0};  ///< of the top layer
};

/// Reads the textures of a hit. Where a map, an average or the corners of a face mix several, one is drawn with its
/// weight as probability; all layers of that one count.
class SurfaceReader {
public:
    SurfaceReader(Context& context, SurfaceLight& out) : context_(context), set_(context.scene.textures), out_(out) {}

    void read(HitContext& hit, const HitDetails& details, Draws& draws);

private:
    struct Stack;
    const texture::Texture& drawn_layers(HitContext& hit, const SideTextures& sides, glm::dvec3& p, Draws& draws);
    void add_layer(HitContext& hit, const texture::Texture& texture, const texture::Layer& layer, const glm::dvec3& p,
                   Stack& stack);
    void add_through(HitContext& hit, const Stack& stack, Draws& draws);

    Context& context_;
    const texture::TextureSet& set_;
    SurfaceLight& out_;
};

}  // namespace trace::path
