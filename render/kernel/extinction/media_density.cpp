#include "render/kernel/extinction/media_density.h"

#include "render/kernel/tile/lane_masks.h"

#include <bit>

namespace trace {
namespace {

/// Points where nothing is black yet.
HitMask not_black(const TileColors& colors, HitMask which)
{
    HitMask out = 0;
    for_each_hit(which, [&](std::size_t k) {
        const bool black_here = colors.red[k] == 0.0f && colors.green[k] == 0.0f && colors.blue[k] == 0.0f;
        if (!black_here) out |= HitMask{1} << k;
    });
    return out;
}

}  // namespace

const texture::Surroundings MediaDensity::kNoSurface{};

const TileColors& MediaDensity::at(const plan::CompiledScene& scene, const plan::Media& media,
                                   const texture::Points& points, HitMask which)
{
    for (std::uint32_t i = 0; i < media.densities; ++i) {
        // Where a density is black the others don't matter; they come in the order of what they cost.
        if (i > 0) which = not_black(density_, which);
        if (which == 0) break;
        const std::uint32_t pigment = scene.media.densities[media.first_density + i];
        const int count = std::popcount(which);
        if (4 * count > 3 * points.count) {
            texture::pigment_colors(scene.textures, pigment, points, around_, colors_);
            multiply_all(which, i == 0);
        } else {
            some_.count = 0;
            some_.density = points.density;
            for_each_hit(which, [&](std::size_t k) { some_.add(points.at(k)); });
            some_.pad();
            texture::pigment_colors(scene.textures, pigment, some_, around_, colors_);
            multiply_some(which, i == 0);
        }
    }
    return density_;
}

/// The colours are in the places of the points.
void MediaDensity::multiply_all(HitMask which, bool first)
{
    if (first) {
        density_.red = colors_.red, density_.green = colors_.green, density_.blue = colors_.blue;
        return;
    }
    const LaneMask here(which);
    const auto multiply = [&](TileFloats& by, const TileFloats& color) {
        for (std::size_t k = 0; k < csg::kTileRays; ++k) by[k] = here[k] != 0 ? by[k] * color[k] : by[k];
    };
    multiply(density_.red, colors_.red);
    multiply(density_.green, colors_.green);
    multiply(density_.blue, colors_.blue);
}

/// The colours are one behind the other.
void MediaDensity::multiply_some(HitMask which, bool first)
{
    std::size_t i = 0;
    for_each_hit(which, [&](std::size_t k) {
        const glm::vec3 color(colors_.red[i], colors_.green[i], colors_.blue[i]);
        density_.set(k, first ? color : density_[k] * color);
        ++i;
    });
}

}  // namespace trace
