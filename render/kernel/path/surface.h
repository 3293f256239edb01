#pragma once

#include "render/kernel/path/bsdf.h"
#include "render/kernel/scatter/refraction.h"

/// From a hit's textures to what it makes of light.
namespace trace::path {

/// A hit as a path needs it.
struct SurfaceLight {
    Bsdf bsdf;
    glm::vec3 emission{0};  ///< radiance towards the ray
    bool passes = false;    ///< light goes on behind it as `through`, if it is not of total reflection
    Refracted through;
    glm::dvec3 normal{0};  ///< of the top layer
};

/// Of the textures that a map, an average or the corners of a face mix one is drawn by its weight; all layers of that
/// count.
class SurfaceReader {
public:
    SurfaceReader(Context& context, SurfaceLight& out) : context_(context), set_(context.scene.textures), out_(out) {}

    /// \param texture of the side that is seen; plan::kNone: nothing but black
    void read(HitContext& hit, const HitDetails& details, std::uint32_t texture, Draws& draws);

private:
    struct Stack;
    std::uint32_t shown(HitContext& hit, const HitDetails& details, std::uint32_t texture, const glm::dvec3& p,
                        Draws& draws);
    const texture::Texture& plain(HitContext& hit, std::uint32_t texture, glm::dvec3& p, Draws& draws);
    glm::dvec3 normal_of(HitContext& hit, std::uint32_t normal, const glm::dvec3& p);
    void add_layer(HitContext& hit, const texture::Texture& texture, const texture::Layer& layer, const glm::dvec3& p,
                   Stack& stack);
    void add_through(HitContext& hit, const Stack& stack, Draws& draws);

    Context& context_;
    const texture::TextureSet& set_;
    SurfaceLight& out_;
};

}  // namespace trace::path
