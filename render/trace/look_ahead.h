#pragma once

#include "render/trace/shade_scratch.h"

#include <algorithm>
#include <cmath>

namespace trace {

/// Pigments of layered textures for `hits` of the tile, whose `layers` are begun, the top layers first: one is asked
/// for only where those above let light through (as shade_layers has it, but for what mirrors take away).
inline void look_ahead(ShadeScratch& scratch, const texture::TextureSet& set, HitMask hits, float bailout)
{
    std::uint32_t most = 1;
    for (std::uint32_t depth = 1; depth <= most; ++depth) {
        for_each_hit(hits, [&](std::size_t k) {
            const LayersAhead& layers = scratch.layers[k];
            const texture::Texture& texture = set.textures[layers.texture];
            most = std::max(most, texture.count);
            if (texture.count < depth || !(layers.residual > bailout)) return;
            scratch.pigments.ask(k, set.layers[texture.first + texture.count - depth].pigment, scratch.points.at(k), scratch.around[k]);
        });
        scratch.pigments.run(set, [&](const std::uint8_t* owner, const texture::ColorPoints& colors, std::size_t count) {
            for (std::size_t i = 0; i < count; ++i) {
                LayersAhead& layers = scratch.layers[owner[i]];
                const scene::Color c = colors.at(i);
                layers.colors[set.textures[layers.texture].count - depth] = c;
                layers.filter *= c.filter * c.rgb() + c.transmit;
                layers.residual = std::min(1.0f, std::abs(scene::grey(layers.filter)));
            }
        });
    }
}

}  // namespace trace
