#pragma once

#include "numbers/functions/functions.h"
#include "numbers/lane_power.h"
#include "render/kernel/tile/lane_masks.h"
#include "numbers/random.h"
#include "render/kernel/context/context.h"
#include "render/kernel/light/highlight_lanes.h"
#include "render/kernel/record/recorder.h"
#include "render/kernel/tile/nearly_zero.h"
#include "render/texture/metallic.h"

#include <algorithm>

/// surface_light() for a page of rows, a hit a lane, in the same order of operations.
namespace trace {

/// Raises the intensities of hits to their finishes' brilliance.
[[gnu::noinline]] inline void raise_intensities(const RowPage& at, HitMask hits, TileLanes& intensity)
{
    using numbers::lanes::Double;
    constexpr HitMask kVector = (HitMask{1} << numbers::lanes::kDoubles) - 1;
    constexpr float kSteepest = 20.0f;  // no cosine above kNearlyZero leaves the range of powers in lanes
    alignas(64) TileLanes exponent;
    exponent.fill(1.0);
    for_each_hit(hits, [&](std::size_t k) {
        const float brilliance = at.finish[k]->brilliance;
        if (brilliance > 0.0f && brilliance < kSteepest) exponent[k] = static_cast<double>(brilliance);
        else intensity[k] = numbers::pow(intensity[k], static_cast<double>(brilliance));
    });
    for (std::size_t i = 0; i < csg::kTileRays; i += numbers::lanes::kDoubles) {
        if ((hits >> i & kVector) == 0) continue;
        const Double v = Double::load_aligned(intensity.data() + i), e = Double::load_aligned(exponent.data() + i);
        const auto raised = (e != Double(1.0)) & (v > Double(0.0));
        const Double base = xsimd::select(raised, v, Double(1.0));
        xsimd::select(raised, numbers::lanes::power(base, e), v).store_aligned(intensity.data() + i);
    }
}

/// Cosines of a page's normals with the light at hand, by amount, raised to the finish's brilliance; those of `on` that
/// turn away from it leave, where they are of `turning`: others have been asked before.
inline void find_intensities(const RowPage& at, const double* const (&n)[3], HitMask turning, const TileLight& light,
                             HitMask& on, TileLanes& intensity)
{
    using numbers::lanes::Double;
    HitMask away = 0;
    each_part_of(on, [&](std::size_t first, FloatMask) {
        for (std::size_t i = first; i < first + kFloatPart; i += numbers::lanes::kDoubles) {
            const auto get = [i](const double* lanes) { return Double::load_aligned(lanes + i); };
            const Double facing = get(n[0]) * get(light.x.data()) + get(n[1]) * get(light.y.data()) +
                                  get(n[2]) * get(light.z.data());
            away |= HitMask{numbers::lanes::mask(facing < Double(kNearlyZero))} << i;
            xsimd::abs(facing).store_aligned(intensity.data() + i);
        }
    });
    on &= ~(away & turning);
    if ((on & at.raised) != 0) raise_intensities(at, on & at.raised, intensity);
}

/// Of hits with metallic finishes, how much of their pigments tints a highlight; 0 of all others.
[[gnu::noinline]] inline void find_tints(const RowPage& at, const double* const (&n)[3], const csg::RayTile& rays,
                                         HitMask tinted, const TileLight& light, TileFloats& share)
{
    using numbers::lanes::Double;
    constexpr HitMask kVector = (HitMask{1} << numbers::lanes::kDoubles) - 1;
    alignas(64) TileLanes metallic{};
    HitMask by_half = 0;
    for_each_hit(tinted, [&](std::size_t k) {
        metallic[k] = static_cast<double>(at.finish[k]->metallic);
        if (at.finish[k]->tint_by_half) by_half |= HitMask{1} << k;
    });
    share.fill(0.0f);
    for (std::size_t i = 0; i < csg::kTileRays; i += numbers::lanes::kDoubles) {
        const HitMask here = tinted & kVector << i;
        if (here == 0) continue;
        const auto get = [i](const double* lanes) { return Double::load_aligned(lanes + i); };
        const Double lx = get(light.x.data()), ly = get(light.y.data()), lz = get(light.z.data());
        alignas(64) std::array<double, numbers::lanes::kDoubles> found;
        const auto take = [&](HitMask of, const Double& cosine) {
            texture::metallic_share(get(metallic.data()), cosine).store_aligned(found.data());
            for_each_hit(of, [&](std::size_t k) { share[k] = static_cast<float>(found[k - i]); });
        };
        if ((here & ~by_half) != 0) take(here & ~by_half, get(n[0]) * lx + get(n[1]) * ly + get(n[2]) * lz);
        if ((here & by_half) == 0) continue;
        const Double hx = lx - get(rays.dx.data()), hy = ly - get(rays.dy.data()), hz = lz - get(rays.dz.data());
        take(here & by_half, (hx * lx + hy * ly + hz * lz) / xsimd::sqrt(hx * hx + hy * hy + hz * hz));
    }
}

/// Adds what a light gives to a page's rows. reached: hits that it reaches, with ShadeScratch::reaching; turning: hits
/// of which some rows may face away from it; grains: numbers of `crand` asked for so far, by hit.
inline void light_page(RowPage& at, HitMask reached, HitMask turning, const light::Light& light,
                       const csg::RayTile& rays, const ShadeScratch& scratch,
                       std::array<std::uint32_t, csg::kTileRays>& grains)
{
    HitMask on = at.holds & reached & ~at.scalar;
    if (on == 0) return;
    const bool bent = at.bent != 0;
    const double* const n[3] = {bent ? at.nx.data() : scratch.hits.nx.data(),
                                bent ? at.ny.data() : scratch.hits.ny.data(),
                                bent ? at.nz.data() : scratch.hits.nz.data()};
    alignas(64) TileLanes intensity;
    find_intensities(at, n, turning, scratch.lamp.light, on, intensity);
    const HitMask shiny = light.shadowless ? 0 : on & at.shiny;
    alignas(64) TileFloats diffuse, strength;
    each_part_of(on, [&](std::size_t i, FloatMask) {
        for (std::size_t k = i; k < i + kFloatPart; ++k) diffuse[k] = static_cast<float>(intensity[k] * at.diffuse[k]);
    });
    for_each_hit(on & at.grainy, [&](std::size_t k) {
        const double less = static_cast<double>(at.finish[k]->crand) *
                            numbers::random_at(scratch.hits.point(k), grains[k]++);
        diffuse[k] = static_cast<float>(intensity[k] * at.diffuse[k] - less);
    });
    tell<&Recorder::diffuse>(scratch, at, on, diffuse);
    if (shiny != 0) {
        alignas(64) TileLanes found;
        find_highlights(rays, n, scratch.lamp.light, at.lobe, shiny, found);
        each_part_of(on, [&](std::size_t i, FloatMask) {
            for (std::size_t k = i; k < i + kFloatPart; ++k) strength[k] = static_cast<float>(found[k]);
            FloatMask(shiny >> i).kept(part(strength, i)).store_aligned(&strength[i]);
        });
    }
    const auto gain = [&](auto&& highlight) {
        for (TileFloats TileColors::*channel : kChannels) {
            const TileFloats &pigments = at.pigment.*channel, &colors = scratch.lamp.reaching.*channel;
            TileFloats& gained = at.gained.*channel;
            each_part_of(on, [&](std::size_t i, FloatMask gains) {
                const FloatPart pigment = part(pigments, i), color = part(colors, i), before = part(gained, i);
                const FloatPart from_diffuse = FloatMask(at.lit >> i).kept(part(diffuse, i) * pigment * color);
                gains.chosen(before + (from_diffuse + highlight(i, color, pigment)), before).store_aligned(&gained[i]);
            });
        }
    };
    const FloatPart none(0.0f), one(1.0f);
    if (shiny == 0) return gain([&](std::size_t, const FloatPart&, const FloatPart&) { return none; });
    // strength times what it is multiplied by, which may be infinite where there is none
    const auto shining = [&](std::size_t i, const FloatPart& by) {
        const FloatPart strong = part(strength, i);
        return xsimd::select(strong != none, strong * by, none);
    };
    const HitMask tinted = at.tinted & shiny;
    if (tinted == 0)
        return gain([&](std::size_t i, const FloatPart& color, const FloatPart&) { return shining(i, color); });
    alignas(64) TileFloats share;
    find_tints(at, n, rays, tinted, scratch.lamp.light, share);
    gain([&](std::size_t i, const FloatPart& color, const FloatPart& pigment) {
        const FloatPart shared = part(share, i);
        return shining(i, color * xsimd::select(shared != none, one + shared * (pigment - one), one));
    });
}

}  // namespace trace
