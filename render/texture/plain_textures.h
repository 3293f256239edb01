#pragma once

#include "render/texture/evaluate.h"

namespace texture {

/// f(texture, point, share) for the textures of layers that a texture shows at p, with maps, averages and pictures of
/// textures resolved; share: times how much of it is seen.
template <class F>
void each_plain(const TextureSet& set, std::uint32_t index, const glm::dvec3& p, const Surroundings& around,
                float share, F&& f)
{
    const Texture& texture = set.textures[index];
    using Kind = Texture::Kind;
    if (texture.kind == Kind::Layers) return f(texture, p, share);
    if (texture.kind == Kind::Uv)
        return each_plain(set, set.children[texture.first], {around.uv.x, around.uv.y, 0.0}, around, share, f);
    const Pattern& pattern = set.patterns[texture.pattern];
    const glm::dvec3 q = warp_point(set, pattern, p);
    if (texture.kind == Kind::Material) return each_plain(set, material_at(set, texture, q), q, around, share, f);
    if (texture.kind == Kind::Average) {
        float weights = 0;
        for (std::uint32_t i = texture.first; i < texture.first + texture.count; ++i) weights += set.keys[i];
        for (std::uint32_t i = texture.first; i < texture.first + texture.count; ++i)
            each_plain(set, set.children[i], q, around, share * set.keys[i] / weights, f);
        return;
    }
    const Blend blend = blend_at(set, texture.first, texture.count, pattern_value(set, pattern, q, around));
    const auto upper = blend.lower == blend.upper ? 1.0f : static_cast<float>(blend.share);
    if (upper < 1.0f) each_plain(set, set.children[blend.lower], q, around, share * (1.0f - upper), f);
    if (upper > 0.0f) each_plain(set, set.children[blend.upper], q, around, share * upper, f);
}

}  // namespace texture
