#pragma once

#include "numbers/lane_equal.h"
#include "render/kernel/context/shade_scratch.h"
#include "render/kernel/surface/surface_scratch.h"

#include <algorithm>
#include <cmath>

namespace trace {

/// What the layers so far let through to the next one, of all hits; a layer's colours are put on top. The hits that
/// more than `bailout` of light passes.
inline HitMask pass_layer(const texture::ColorPoints& c, TileColors& filter, float bailout)
{
    alignas(64) std::array<std::uint32_t, csg::kTileRays> open;
    for (std::size_t k = 0; k < csg::kTileRays; ++k) {
        filter.red[k] *= c.filter[k] * c.red[k] + c.transmit[k];
        filter.green[k] *= c.filter[k] * c.green[k] + c.transmit[k];
        filter.blue[k] *= c.filter[k] * c.blue[k] + c.transmit[k];
        const float residual =
            std::abs(0.297f * filter.red[k] + 0.589f * filter.green[k] + 0.114f * filter.blue[k]);  // scene::grey
        open[k] = (residual < 1.0f ? residual : 1.0f) > bailout ? 1 : 0;
    }
    return numbers::lanes::equal(open, 1);
}

/// Pigments of layered textures for the tile's hits that have such, the top layers first: one is asked for only where
/// those above let light through (as shade_layers has it, but for what mirrors take away). The hits that light passes
/// all layers of.
inline HitMask prefetch_pigments(ShadeScratch& scratch, const texture::TextureSet& set, float bailout)
{
    SurfaceScratch& own = scratch.surface();
    std::uint32_t most = 0;
    HitMask open = 0;
    for (std::size_t g = 0; g < own.layered_count; ++g) {
        open |= own.layered[g].hits;
        most = std::max(most, set.textures[own.layered[g].texture].count);
    }
    TileColors filter;
    filter.fill(1.0f);
    scratch.patterns.asked.fill(0);
    for (std::uint32_t depth = 0; depth < most; ++depth) {
        HitMask asked = 0;
        for (std::size_t g = 0; g < own.layered_count; ++g) {
            const LayeredGroup& group = own.layered[g];
            const texture::Texture& texture = set.textures[group.texture];
            const HitMask hits = group.hits & open;
            if (texture.count <= depth || hits == 0) continue;
            asked |= hits;
            own.pigments.ask(hits, set.layers[texture.first + texture.count - 1 - depth].pigment,
                             scratch.patterns.points, scratch.patterns.around);
        }
        if (asked == 0) break;
        texture::ColorPoints& colors = scratch.patterns.layers[depth].colors;
        own.pigments.run(set, [&](HitMask hits, const texture::ColorPoints& found) {
            if (hits == asked) colors = found;
            else for_each_hit(hits, [&](std::size_t k) { colors.set(k, found.at(k)); });
        });
        scratch.patterns.asked[depth] = asked;
        if (scratch.rows.pages.size() <= depth) scratch.rows.pages.resize(depth + 1);
        scratch.rows.pages[depth].filter = filter;
        open = (open & ~asked) | (asked & pass_layer(colors, filter, bailout));
    }
    return open;
}

}  // namespace trace
