#pragma once

#include "render/texture/texture_set.h"

#include <vector>

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

/// No colour of the pigment lets light through, so that its pattern does not matter. known: those of pigments before
/// it.
inline bool dark(const texture::TextureSet& set, const texture::Pigment& pigment, const std::vector<bool>& known)
{
    using Kind = texture::Pigment::Kind;
    if (pigment.kind == Kind::Image) return false;  // it may be missing
    if (pigment.kind == Kind::Solid) return no_light(pigment.color);
    if (pigment.kind == Kind::Average && !has_weight(set, pigment.first, pigment.count)) return false;
    const std::uint32_t count = pigment.kind == Kind::Uv ? 1 : pigment.count;
    for (std::uint32_t i = pigment.first; i < pigment.first + count; ++i)
        if (!(pigment.kind == Kind::ColorMap ? no_light(set.colors[i]) : known[set.children[i]])) return false;
    return count != 0;
}

inline bool dark(const texture::TextureSet& set, const texture::Texture& texture, const std::vector<bool>& pigments,
                 const std::vector<bool>& known)
{
    using Kind = texture::Texture::Kind;
    if (texture.kind == Kind::Layers) {
        for (std::uint32_t i = texture.first; i < texture.first + texture.count; ++i)
            if (pigments[set.layers[i].pigment]) return true;
        return false;
    }
    if (texture.kind == Kind::Average && !has_weight(set, texture.first, texture.count)) return false;
    const std::uint32_t count = texture.kind == Kind::Uv ? 1 : texture.count;
    for (std::uint32_t i = texture.first; i < texture.first + count; ++i)
        if (!known[set.children[i]]) return false;
    return count != 0;
}

}  // namespace detail

/// By texture: its filter is 0 wherever it is asked. What is inside of a map stands before the map in the set, so that
/// each is looked at once, however many maps share it.
inline std::vector<bool> dark_textures(const texture::TextureSet& set)
{
    std::vector<bool> pigments, textures;
    for (const texture::Pigment& pigment : set.pigments) pigments.push_back(detail::dark(set, pigment, pigments));
    for (const texture::Texture& texture : set.textures)
        textures.push_back(detail::dark(set, texture, pigments, textures));
    return textures;
}

}  // namespace plan
