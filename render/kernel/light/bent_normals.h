#pragma once

#include "render/texture/evaluate_points.h"
#include "render/kernel/context/shade_scratch.h"

#include <bit>

namespace trace {

/// Normals of a tile's hits as a layer bends them, of unit length, at the hits' places of x, y and z; other places keep
/// what they have. The hits' points and surroundings (ShadeScratch::points, around) are known.
inline void bend_normals(const texture::TextureSet& set, std::uint32_t normal, HitMask hits,
                         const ShadeScratch& scratch, TileLanes& x, TileLanes& y, TileLanes& z)
{
    const TileHits& places = scratch.hits;
    texture::Points points, n;
    texture::Around around;
    const bool in_order = (hits & (hits + 1)) == 0;  // the first so many
    if (in_order) {
        points.take(scratch.patterns.points, std::popcount(hits));
        for (std::size_t k = 0; k < points.size(); ++k) {
            n.add({places.nx[k], places.ny[k], places.nz[k]});
            around[k] = &scratch.patterns.around[k];
        }
    } else {
        for_each_hit(hits, [&](std::size_t k) {
            around[points.size()] = &scratch.patterns.around[k];
            points.add(scratch.patterns.points.at(k));
            n.add(places.normal(k));
        });
    }
    points.pad();
    n.pad();
    texture::perturb_points(set, normal, points, around, n);
    texture::normalize_points(n);
    std::size_t i = 0;
    for_each_hit(hits, [&](std::size_t k) {
        x[k] = n.x[i];
        y[k] = n.y[i];
        z[k] = n.z[i++];
    });
}

}  // namespace trace
