#pragma once

#include "render/texture/texture_set.h"

/// Textures that let no light through at any place.
namespace plan {

namespace detail {

inline bool no_light(const scene::Color& c) { return c.filter == 0.0f && c.transmit == 0.0f; }

/// Whether weights of an average divide by a number.
inline bool has_weight(const texture::TextureSet& set, std::uint32_t first, std::uint32_t count)
{
    float sum = 0.0f;
    for (std::uint32_t i = first; i < first + count; ++i) sum += set.keys[i];
    return sum > 0.0f;
}

/// No colour of the pigment lets light through, so that its pattern does not matter.
inline bool dark_pigment(const texture::TextureSet& set, std::uint32_t index)
{
    using Kind = texture::Pigment::Kind;
    const texture::Pigment& pigment = set.pigments[index];
    if (pigment.kind == Kind::Image) return false;  // it may be missing
    if (pigment.kind == Kind::Solid) return no_light(pigment.color);
    if (pigment.kind == Kind::Average && !has_weight(set, pigment.first, pigment.count)) return false;
    const std::uint32_t count = pigment.kind == Kind::Uv ? 1 : pigment.count;
    for (std::uint32_t i = pigment.first; i < pigment.first + count; ++i)
        if (!(pigment.kind == Kind::ColorMap ? no_light(set.colors[i]) : dark_pigment(set, set.children[i])))
            return false;
    return count != 0;
}

}  // namespace detail

/// The texture's filter is 0 wherever it is asked.
inline bool dark_texture(const texture::TextureSet& set, std::uint32_t index)
{
    using Kind = texture::Texture::Kind;
    const texture::Texture& texture = set.textures[index];
    if (texture.kind == Kind::Layers) {
        for (std::uint32_t i = texture.first; i < texture.first + texture.count; ++i)
            if (detail::dark_pigment(set, set.layers[i].pigment)) return true;
        return false;
    }
    if (texture.kind == Kind::Average && !detail::has_weight(set, texture.first, texture.count)) return false;
    const std::uint32_t count = texture.kind == Kind::Uv ? 1 : texture.count;
    for (std::uint32_t i = texture.first; i < texture.first + count; ++i)
        if (!dark_texture(set, set.children[i])) return false;
    return count != 0;
}

}  // namespace plan
