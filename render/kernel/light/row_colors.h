#pragma once

#include "numbers/lanes.h"
#include "render/kernel/tile/lane_masks.h"
#include "render/kernel/tile/row_page.h"

/// What the pigments of a tile's hits make of a page of rows.
namespace trace {

/// Hits that get their pigments.
struct ColoredHits {
    HitMask hits, clear;  ///< of them, those that their opacity dims; the others count as opaque
    bool legacy_opacity;  ///< of scenes before version 3.7
    bool keeps_alpha;     ///< indirect light asks for it
};

/// Hit by hit.
inline void color_each(RowPage& at, const ColoredHits& of, const texture::ColorPoints& c)
{
    for_each_hit(of.hits, [&](std::size_t k) {
        const scene::Color own = c.at(k);
        const float alpha = has(of.clear, k) ? texture::opacity(own, of.legacy_opacity) : 1.0f;
        if (of.keeps_alpha) at.alpha[k] = alpha;
        const glm::vec3 rgb = own.rgb();
        at.pigment.set(k, rgb);
        at.glow.set(k, rgb * at.emitted[k] * alpha);
        at.diffuse[k] = static_cast<double>(at.finish_diffuse[k]) * static_cast<double>(alpha);
    });
}

/// Pigment, glow and diffuse share of the rows of some hits; the same bits for few of them as for many.
inline void color_rows(RowPage& at, const ColoredHits& of, const texture::ColorPoints& c)
{
    if (few(of.hits)) return color_each(at, of, c);
    alignas(64) TileFloats alpha;
    alpha.fill(1.0f);
    if (of.clear != 0 && of.legacy_opacity) {
        for_each_hit(of.hits & of.clear, [&](std::size_t k) { alpha[k] = texture::opacity(c.at(k), true); });
    } else if (of.clear != 0) {
        each_part_of(of.clear, [&](std::size_t i, FloatMask counts) {
            const FloatPart one(1.0f);
            counts.chosen(one - part(c.filter, i) - part(c.transmit, i), one).store_aligned(alpha.data() + i);
        });
    }
    if (of.keeps_alpha)
        each_part_of(of.hits, [&](std::size_t i, FloatMask here) {
            here.chosen(part(alpha, i), part(at.alpha, i)).store_aligned(at.alpha.data() + i);
        });
    const auto component = [&](const std::array<float, csg::kTileRays>& from, TileFloats TileColors::*channel) {
        TileFloats &pigment = at.pigment.*channel, &glow = at.glow.*channel;
        each_part_of(of.hits, [&](std::size_t i, FloatMask here) {
            const FloatPart own = part(from, i);
            here.chosen(own, part(pigment, i)).store_aligned(pigment.data() + i);
            here.chosen(own * part(at.emitted.*channel, i) * part(alpha, i), part(glow, i))
                .store_aligned(glow.data() + i);
        });
    };
    component(c.red, &TileColors::red);
    component(c.green, &TileColors::green);
    component(c.blue, &TileColors::blue);
    using numbers::lanes::Double;
    constexpr HitMask kVector = (HitMask{1} << numbers::lanes::kDoubles) - 1;
    each_part_of(of.hits, [&](std::size_t first, FloatMask) {
        alignas(64) std::array<double, kFloatPart> diffuse;
        for (std::size_t k = 0; k < kFloatPart; ++k)
            diffuse[k] = static_cast<double>(at.finish_diffuse[first + k]) * static_cast<double>(alpha[first + k]);
        for (std::size_t k = 0; k < kFloatPart; k += numbers::lanes::kDoubles) {
            double* to = at.diffuse.data() + first + k;
            xsimd::select(numbers::lanes::lanes_of(static_cast<std::uint32_t>(of.hits >> (first + k) & kVector)),
                          Double::load_aligned(diffuse.data() + k), Double::load_aligned(to))
                .store_aligned(to);
        }
    });
}

}  // namespace trace
