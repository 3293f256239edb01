#pragma once

#include "render/texture/evaluate_points.h"
#include "render/trace/lane_masks.h"
#include "render/trace/shade_context.h"
#include "render/trace/shade_light.h"

#include <algorithm>
#include <cmath>

/// A tile's hits on surfaces of colours, diffuse light and highlights: all of them go through a light together, a hit a lane. The
/// operations are those of surface_light() in the same order. Compiled once per instruction set.
namespace trace {

class FlatHits {
public:
    explicit FlatHits(Context& context) : set_(context.scene.textures), scratch_(context.scratch.shade),
          bends_normals_(context.scene.settings.quality >= 8)
    {
    }

    bool holds(std::size_t k) const { return has(holds_, k); }
    /// It has its colour once the lights are through.
    bool done(std::size_t k) const { return has(holds_ & ~goes_on_, k); }
    bool bent(std::size_t k) const { return has(bent_, k); }
    HitMask all() const { return holds_; }
    HitMask all_bent() const { return bent_; }
    /// Those that light changes.
    HitMask lit() const { return lit_; }

    const texture::Finish& top_finish(std::size_t k) const { return *scratch_.flat[0].finish[k]; }
    scene::Color top_pigment(std::size_t k) const { return scratch_.top_pigments.at(k); }

    /// Hits of one layer; their pigments come by color().
    void begin(HitMask hits, const LoneLayer& lone)
    {
        holds_ |= hits;
        if (lone.goes_on) goes_on_ |= hits;
        const texture::Layer& layer = set_.layers[lone.index];
        if (set_.finishes[layer.finish].lit()) lit_ |= hits;
        add_layer(0, hits, layer);
    }

    void color(HitMask hits, const texture::ColorPoints& c)
    {
        for_each_hit(hits & goes_on_, [&](std::size_t k) { scratch_.top_pigments.set(k, c.at(k)); });
        color(scratch_.flat[0], hits, hits & goes_on_, c);
    }

    /// Hits of layers whose pigments are known, by depth where the hits of `asked` have one; they let nothing through to what is behind.
    void begin(HitMask hits, const texture::Texture& texture)
    {
        holds_ |= hits;
        lit_ |= hits;
        for (std::uint32_t depth = 0; depth < texture.count; ++depth) {
            const HitMask here = hits & scratch_.asked[depth];
            if (here == 0) return;
            FlatDepth& at = add_layer(depth, here, set_.layers[texture.first + texture.count - 1 - depth]);
            color(at, here, texture.plain ? 0 : here, scratch_.ahead[depth]);
        }
    }

    /// Bends the normals of the layers that have some; their places and surroundings are known.
    void bend()
    {
        for (std::size_t depth = 0; depth < depths_; ++depth) {
            FlatDepth& at = scratch_.flat[depth];
            if (at.bent == 0) continue;
            at.nx = scratch_.hits.nx;
            at.ny = scratch_.hits.ny;
            at.nz = scratch_.hits.nz;
        }
        for (std::size_t i = 0; i < bends_; ++i) bend(scratch_.bends[i]);
        bends_ = 0;
    }

    /// Some layer of a bent hit faces the direction.
    bool faces(std::size_t k, const glm::dvec3& direction) const
    {
        for (std::size_t depth = 0; depth < depths_ && has(scratch_.flat[depth].holds, k); ++depth) {
            const FlatDepth& at = scratch_.flat[depth];
            const glm::dvec3 n = at.bent != 0 ? at.normal(k) : scratch_.hits.normal(k);
            if (!(glm::dot(n, direction) < kNearlyZero)) return true;
        }
        return false;
    }

    /// The colour of the light at hand, of all hits or of one.
    void begin_light(const glm::vec3& color)
    {
        scratch_.reaching.red.fill(color.x);
        scratch_.reaching.green.fill(color.y);
        scratch_.reaching.blue.fill(color.z);
        dark_ = dark(color) ? ~HitMask{0} : 0;
    }
    void begin_light(std::size_t k, const glm::vec3& color)
    {
        scratch_.reaching.set(k, color);
        dark_ = dark(color) ? dark_ | HitMask{1} << k : dark_ & ~(HitMask{1} << k);
    }

    /// It reaches these hits.
    void light(HitMask hits) { reached_ |= hits & ~dark_; }
    /// It reaches hit k with another colour.
    void light(std::size_t k, const glm::vec3& color)
    {
        begin_light(k, color);
        light(HitMask{1} << k);
    }

    /// Adds what the light at hand gives to the hits that it reaches; it is over then.
    void add(const light::Light& light, const csg::RayTile& rays)
    {
        for (std::size_t depth = 0; depth < depths_ && reached_ != 0; ++depth) add(scratch_.flat[depth], light, rays);
        reached_ = 0;
    }

    /// Lights from here to end_group() are summed by themselves first.
    void begin_group()
    {
        for (std::size_t depth = 0; depth < depths_; ++depth) {
            FlatDepth& at = scratch_.flat[depth];
            at.gained_before = at.gained;
            at.gained.fill(0.0f);
        }
    }
    void end_group()
    {
        for (std::size_t depth = 0; depth < depths_; ++depth) {
            FlatDepth& at = scratch_.flat[depth];
            for (TileFloats TileColors::*channel : {&TileColors::red, &TileColors::green, &TileColors::blue})
                for (std::size_t k = 0; k < csg::kTileRays; ++k) (at.gained.*channel)[k] = (at.gained_before.*channel)[k] + (at.gained.*channel)[k];
        }
    }

    /// Light of all layers as the viewer sees it, for sum(k).
    void finish()
    {
        if (depths_ == 0) return;
        TileColors& sums = scratch_.sums;
        const auto each = [&](TileFloats TileColors::*channel) {
            float* sum = (sums.*channel).data();
            for (std::size_t depth = 0; depth < depths_; ++depth) {
                const FlatDepth& at = scratch_.flat[depth];
                const LaneMask here(at.holds);
                const float *glow = (at.glow.*channel).data(), *gained = (at.gained.*channel).data(), *filter = (at.filter.*channel).data();
                if (depth == 0) {
                    for (std::size_t k = 0; k < csg::kTileRays; ++k) sum[k] = glow[k] + gained[k];
                    continue;
                }
                // The top layer's filter is 1.
                for (std::size_t k = 0; k < csg::kTileRays; ++k) sum[k] += here[k] != 0 ? filter[k] * (glow[k] + gained[k]) : 0.0f;
            }
        };
        each(&TileColors::red);
        each(&TileColors::green);
        each(&TileColors::blue);
    }
    glm::vec3 sum(std::size_t k) const { return scratch_.sums[k]; }

private:
    static bool dark(const glm::vec3& c) { return !(std::abs(c.x) > kDark || std::abs(c.y) > kDark || std::abs(c.z) > kDark); }

    FlatDepth& add_layer(std::size_t depth, HitMask hits, const texture::Layer& of)
    {
        FlatDepth& at = scratch_.flat[depth];
        if (depth == depths_) {
            ++depths_;
            at.holds = at.bent = at.lit = at.shiny = at.raised = at.tinted = 0;
            at.gained.fill(0.0f);
        }
        const texture::Finish& finish = set_.finishes[of.finish];
        const glm::vec3 emitted = finish.ambient + finish.emission;
        const bool shiny = finish.phong > 0.0f || finish.specular > 0.0f;
        if (at.holds == 0) {   // places that other hits take are written again
            at.finish.fill(&finish);
            at.emitted.red.fill(emitted.x);
            at.emitted.green.fill(emitted.y);
            at.emitted.blue.fill(emitted.z);
            at.finish_diffuse.fill(finish.diffuse);
            if (shiny) at.shine.fill(finish);
        } else {
            for_each_hit(hits, [&](std::size_t k) {
                at.finish[k] = &finish;
                at.emitted.set(k, emitted);
                at.finish_diffuse[k] = finish.diffuse;
                if (shiny) at.shine.set(k, finish);
            });
        }
        at.holds |= hits;
        if (finish.diffuse > 0.0f) at.lit |= hits;
        if (shiny) at.shiny |= hits;
        if (finish.brilliance != 1.0f) at.raised |= hits;
        if (finish.metallic > 0.0f) at.tinted |= hits;
        if (of.normal != texture::kNone && bends_normals_) {
            at.bent |= hits;
            bent_ |= hits;
            scratch_.bends[bends_++] = {hits, of.normal, static_cast<std::uint8_t>(depth)};
        }
        return at;
    }

    /// Unit normals of a layer's hits.
    void bend(const Bend& of)
    {
        const TileHits& places = scratch_.hits;
        texture::Points points, n;
        texture::Around around;
        if ((of.hits & (of.hits + 1)) == 0) {   // the first so many
            points = scratch_.points;
            n.x.v = places.nx;
            n.y.v = places.ny;
            n.z.v = places.nz;
            points.count = n.count = std::popcount(of.hits);
            for (std::size_t k = 0; k < points.size(); ++k) around[k] = &scratch_.around[k];
        } else {
            for_each_hit(of.hits, [&](std::size_t k) {
                around[points.size()] = &scratch_.around[k];
                points.add(scratch_.points.at(k));
                n.add(places.normal(k));
            });
        }
        points.pad();
        n.pad();
        texture::perturb_points(set_, of.normal, points, around, n);
        FlatDepth& at = scratch_.flat[of.depth];
        std::size_t i = 0;
        for_each_hit(of.hits, [&](std::size_t k) {
            const glm::dvec3 unit = glm::normalize(n.at(i++));
            at.nx[k] = unit.x;
            at.ny[k] = unit.y;
            at.nz[k] = unit.z;
        });
    }

    /// Pigments of hits; of some, `clear`, opacity counts.
    void color(FlatDepth& at, HitMask hits, HitMask clear, const texture::ColorPoints& c)
    {
        const LaneMask here(hits), counts(clear);
        alignas(64) TileFloats alpha;
        alpha.fill(1.0f);
        if (clear != 0 && set_.legacy_opacity) {
            for_each_hit(hits & clear, [&](std::size_t k) { alpha[k] = texture::opacity(c.at(k), true); });
        } else if (clear != 0) {
            for (std::size_t k = 0; k < csg::kTileRays; ++k) alpha[k] = counts[k] != 0 ? 1.0f - c.filter[k] - c.transmit[k] : 1.0f;
        }
        const auto component = [&](const std::array<float, csg::kTileRays>& from, TileFloats TileColors::*channel) {
            float *pigment = (at.pigment.*channel).data(), *glow = (at.glow.*channel).data();
            const float* emitted = (at.emitted.*channel).data();
            for (std::size_t k = 0; k < csg::kTileRays; ++k) {
                pigment[k] = here[k] != 0 ? from[k] : pigment[k];
                glow[k] = here[k] != 0 ? from[k] * emitted[k] * alpha[k] : glow[k];
            }
        };
        component(c.red, &TileColors::red);
        component(c.green, &TileColors::green);
        component(c.blue, &TileColors::blue);
        for (std::size_t k = 0; k < csg::kTileRays; ++k) {
            const double diffuse = static_cast<double>(at.finish_diffuse[k]) * static_cast<double>(alpha[k]);
            at.diffuse[k] = here[k] != 0 ? diffuse : at.diffuse[k];
        }
    }

    void add(FlatDepth& at, const light::Light& light, const csg::RayTile& rays)
    {
        using csg::lanes::Double;
        HitMask on = at.holds & reached_;
        if (on == 0) return;
        const bool bent = at.bent != 0;
        const double* n[3] = {bent ? at.nx.data() : scratch_.hits.nx.data(), bent ? at.ny.data() : scratch_.hits.ny.data(),
                              bent ? at.nz.data() : scratch_.hits.nz.data()};
        alignas(64) TileLanes intensity{};
        HitMask away = 0;
        for (int i = 0; i < rays.count; i += csg::lanes::kDoubles) {
            const auto get = [i](const double* lanes) { return Double::load_aligned(lanes + i); };
            const Double facing = get(n[0]) * get(scratch_.light.x.data()) + get(n[1]) * get(scratch_.light.y.data()) + get(n[2]) * get(scratch_.light.z.data());
            away |= HitMask{csg::lanes::mask(facing < Double(kNearlyZero))} << i;
            xsimd::abs(facing).store_aligned(intensity.data() + i);
        }
        on &= ~(away & bent_);
        for_each_hit(on & at.raised, [&](std::size_t k) { intensity[k] = std::pow(intensity[k], static_cast<double>(at.finish[k]->brilliance)); });
        const HitMask shiny = light.shadowless ? 0 : on & at.shiny;
        TileFloats diffuse, strength{};
        for (std::size_t k = 0; k < csg::kTileRays; ++k) diffuse[k] = static_cast<float>(intensity[k] * at.diffuse[k]);
        if (shiny != 0) {
            alignas(64) TileLanes found{};
            find_highlights(rays, n, scratch_.light, at.shine, shiny, found);
            const LaneMask shines(shiny);
            for (std::size_t k = 0; k < csg::kTileRays; ++k) strength[k] = shines[k] != 0 ? static_cast<float>(found[k]) : 0.0f;
        }
        const HitMask tinted = at.tinted & shiny, plain = on & ~tinted;
        const LaneMask gains(plain), has_diffuse(at.lit);
        const auto gain = [&](TileFloats TileColors::*channel) {
            const float *pigment = (at.pigment.*channel).data(), *color = (scratch_.reaching.*channel).data();
            float* gained = (at.gained.*channel).data();
            for (std::size_t k = 0; k < csg::kTileRays; ++k) {
                const float from_diffuse = has_diffuse[k] != 0 ? diffuse[k] * pigment[k] * color[k] : 0.0f;
                const float light_here = from_diffuse + (strength[k] != 0.0f ? strength[k] * color[k] : 0.0f);
                gained[k] = gains[k] != 0 ? gained[k] + light_here : gained[k];
            }
        };
        gain(&TileColors::red);
        gain(&TileColors::green);
        gain(&TileColors::blue);
        for_each_hit(tinted, [&](std::size_t k) {
            const glm::vec3 color = scratch_.reaching[k], rgb = at.pigment[k];
            glm::vec3 sum = has(at.lit, k) ? diffuse[k] * rgb * color : glm::vec3(0);
            const glm::dvec3 normal{n[0][k], n[1][k], n[2][k]};
            if (strength[k] != 0.0f) sum += strength[k] * texture::highlight_color(*at.finish[k], color, scene::Color::of(rgb), normal, scratch_.light.direction(k));
            at.gained.set(k, at.gained[k] + sum);
        });
    }

    const texture::TextureSet& set_;
    ShadeScratch& scratch_;
    const bool bends_normals_;
    HitMask holds_ = 0, goes_on_ = 0, bent_ = 0, lit_ = 0, reached_ = 0, dark_ = 0;
    std::size_t depths_ = 0, bends_ = 0;
};

}  // namespace trace
