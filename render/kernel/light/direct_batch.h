#pragma once

#include "render/texture/evaluate_points.h"
#include "render/kernel/light/bent_normals.h"
#include "render/kernel/light/direct_light.h"
#include "render/kernel/light/row_colors.h"
#include "render/kernel/light/row_light.h"
#include "render/kernel/light/shade_light.h"
#include "render/kernel/record/recorder.h"

#include <algorithm>
#include <cmath>

/// The rows of light of a tile's hits, a row for each layer of a hit's texture. All rows go through a light together, a
/// hit a lane; row d of every hit lies on page d. Rows that lanes have no formula for (grain, iridescence, light from
/// behind) go through the lights one by one at the end. The operations are those of surface_light() in the same order.
namespace trace {

class DirectBatch {
public:
    /// count: hits and misses of the tile.
    DirectBatch(Context& context, int count)
        : context_(context), count_(count), set_(context.scene.textures), scratch_(context.scratch.shade)
    {
        rows_.fill(0);
        scratch_.rows.closing.clear();
        scratch_.rows.laid.clear();
    }

    bool holds(std::size_t k) const { return has(holds_, k); }  ///< whether hit k has rows
    HitMask all() const { return holds_; }
    std::uint32_t rows(std::size_t k) const { return rows_[k]; }  ///< of hit k, so far
    /// Whether the colour of hit k is the sum of its rows: no ray goes on from it and no textures are mixed.
    bool alone(std::size_t k) const { return has(alone_, k); }
    HitMask all_alone() const { return alone_; }
    bool bent(std::size_t k) const { return has(bent_, k); }  ///< whether a layer of hit k bends the normal
    HitMask all_bent() const { return bent_; }
    HitMask lit() const { return lit_; }              ///< hits whose colour depends on lights
    HitMask two_sided() const { return two_sided_; }  ///< hits that light from behind reaches too
    HitMask scalar() const { return scalar_; }        ///< hits with rows that go through the lights one by one

    const texture::Finish& top_finish(std::size_t k) const { return *scratch_.rows.pages[0].finish[k]; }
    scene::Color top_pigment(std::size_t k) const { return scratch_.rows.top_pigments.at(k); }

    /// Hits of a texture of one layer; color() hands in their pigments later.
    void begin(HitMask hits, const plan::SingleLayer& single)
    {
        hold(hits);
        if (single.goes_on) goes_on_ |= hits;
        else alone_ |= hits;
        const texture::Layer& layer = set_.layers[single.index];
        if (set_.finishes[layer.finish].lit()) lit_ |= hits;
        if (single.dull) dull_ |= hits;
        add_layer(0, hits, layer);
        for_each_hit(hits, [&](std::size_t k) { rows_[k] = 1; });
        if (set_.finishes[layer.finish].crand > 0.0f) for_each_hit(hits, [&](std::size_t k) { grains_[k] = 0; });
    }

    void color(HitMask hits, const texture::ColorPoints& c)
    {
        for_each_hit(hits & goes_on_, [&](std::size_t k) { scratch_.rows.top_pigments.set(k, c.at(k)); });
        color(scratch_.rows.pages[0], hits, hits & goes_on_, c);
        if ((hits & dull_) != 0) drop_clear(hits & dull_, c);
    }

    /// Hits of layers whose pigments are known, by depth where the hits of `asked` have one; they let nothing through
    /// to what is behind.
    void begin(HitMask hits, const texture::Texture& texture)
    {
        hold(hits);
        alone_ |= hits;
        lit_ |= hits;
        for (std::uint32_t depth = 0; depth < texture.count; ++depth) {
            const HitMask here = hits & scratch_.patterns.asked[depth];
            if (here == 0) return;
            RowPage& at = add_layer(depth, here, set_.layers[texture.first + texture.count - 1 - depth]);
            color(at, here, texture.plain ? 0 : here, scratch_.patterns.layers[depth].colors);
            for_each_hit(here, [&](std::size_t k) { rows_[k] = static_cast<std::uint16_t>(depth + 1); });
        }
    }

    /// The first page from which on so many have no rows of these hits, all of whose rows are laid.
    std::size_t room(HitMask hits, std::size_t pages) const
    {
        const std::vector<HitMask>& laid = scratch_.rows.laid;
        std::size_t first = 0;
        for (std::size_t d = 0; d < std::min(first + pages, laid.size()); ++d)
            if ((laid[d] & hits) != 0) first = d + 1;
        return first;
    }

    /// Rows of a layer for hits whose colour some others will make of them, and from which no ray goes on. Its pigments
    /// and what the layers above let through are known, and normals, if it bends them; plain: it is opaque.
    void lay(std::size_t d, HitMask hits, const texture::Layer& layer, const TileColors& filter, bool plain,
             const texture::ColorPoints& c, const BentNormals& normals)
    {
        hold(hits);
        alone_ |= hits;
        if (set_.finishes[layer.finish].lit()) lit_ |= hits;
        RowPage& at = add_finish(d, hits, layer);
        if (layer.normal != texture::kNone) {
            own_normals(at, hits);
            for_each_hit(hits, [&](std::size_t k) {
                at.nx[k] = normals.x[k];
                at.ny[k] = normals.y[k];
                at.nz[k] = normals.z[k];
            });
        }
        if (d == scratch_.rows.laid.size()) scratch_.rows.laid.push_back(0);
        scratch_.rows.laid[d] |= hits;
        for (TileFloats TileColors::*channel : kChannels)
            each_part_of(hits, [&](std::size_t i, FloatMask here) {
                here.chosen(part(filter.*channel, i), part(at.filter.*channel, i))
                    .store_aligned((at.filter.*channel).data() + i);
            });
        color(at, hits, plain ? 0 : hits, c);
    }

    void add_row(std::size_t k, const LitRow& row)
    {
        constexpr double kUnit = 1e-9;
        const HitMask bit = HitMask{1} << k;
        const texture::Finish& finish = row.finish;
        RowPage& at = page(rows_[k]++);
        hold(bit);
        at.holds |= bit;
        at.finish[k] = &finish;
        at.pigment.set(k, row.pigment.rgb());
        at.glow.set(k, row.pigment.rgb() * (finish.ambient + finish.emission) * row.alpha * row.glows);
        at.filter.set(k, row.filter);
        at.alpha[k] = row.alpha;
        at.passes[k] = {row.pigment.filter, row.pigment.transmit};
        if (!finish.lit()) return;
        if (row.alpha != 0.0f || !context_.traits.clear_surfaces || !finish.dull()) lit_ |= bit;
        if (row.normal != row.raw_normal) {
            own_normals(at, bit);
            at.nx[k] = row.normal.x;
            at.ny[k] = row.normal.y;
            at.nz[k] = row.normal.z;
        }
        if (row.two_sided || finish.diffuse_back != 0.0f) two_sided_ |= bit;
        const bool unit = std::abs(glm::dot(row.normal, row.normal) - 1.0) < kUnit;
        if (row.two_sided || finish.diffuse_back != 0.0f || finish.crand != 0.0f || finish.irid != 0.0f ||
            finish.own_light || !unit || context_.traits.scalar_rows) {
            at.scalar |= bit;
            scalar_ |= bit;
            at.scalar_pigment.set(k, row.pigment);
            return;
        }
        at.diffuse[k] = static_cast<double>(finish.diffuse) * static_cast<double>(row.alpha);
        set_kind(at, bit, finish);
        if (finish.phong > 0.0f || finish.specular > 0.0f) at.lobe.set(k, finish);
    }

    /// A node of the queue waits for the light of those rows of hit k that lie from `first` to here.
    void close_node(std::size_t k, std::uint32_t first, std::uint32_t node)
    {
        scratch_.rows.closing.push_back(
            {node, static_cast<std::uint8_t>(k), static_cast<std::uint16_t>(first), rows_[k]});
    }

    /// Bends the normals of the layers that have some; their places and surroundings are known.
    void bend()
    {
        for (std::size_t i = 0; i < bends_; ++i) bend(scratch_.rows.bends[i]);
        bends_ = 0;
    }

    /// Some layer of a bent hit faces the direction.
    bool faces(std::size_t k, const glm::dvec3& direction) const
    {
        for (std::size_t depth = 0; depth < depths_; ++depth) {
            const RowPage& at = scratch_.rows.pages[depth];
            if (!has(at.holds, k)) continue;
            const glm::dvec3 n = at.bent != 0 ? at.normal(k) : scratch_.hits.normal(k);
            if (!(glm::dot(n, direction) < kNearlyZero)) return true;
        }
        return false;
    }

    /// Sets the colour that the current light has at all hits, or at hit k.
    void begin_light(const glm::vec3& color)
    {
        scratch_.lamp.reaching.fill(color, count_);
        dark_ = dark(color) ? ~HitMask{0} : 0;
    }
    void begin_light(std::size_t k, const glm::vec3& color)
    {
        scratch_.lamp.reaching.set(k, color);
        dark_ = dark(color) ? dark_ | HitMask{1} << k : dark_ & ~(HitMask{1} << k);
    }

    /// The current light reaches these hits.
    void light(HitMask hits) { reached_ |= hits & ~dark_; }
    /// The current light reaches hit k, with a colour of its own there.
    void light(std::size_t k, const glm::vec3& color)
    {
        begin_light(k, color);
        light(HitMask{1} << k);
    }

    /// Adds what the current light gives to the rows of the hits that it reaches, and ends that light.
    void add(const light::Light& light, const csg::RayTile& rays)
    {
        for (std::size_t depth = 0; depth < depths_ && reached_ != 0; ++depth)
            light_page(scratch_.rows.pages[depth], reached_, bent_ | two_sided_, light, rays, scratch_, grains_);
        reached_ = 0;
    }

    /// Lights up to end_group() are summed by themselves first: the nodes of an area light with area_illumination.
    void begin_group()
    {
        for (std::size_t depth = 0; depth < depths_; ++depth) {
            RowPage& at = scratch_.rows.pages[depth];
            at.gained_before = at.gained;
            at.gained.fill(glm::vec3(0), count_);
        }
    }
    void end_group()
    {
        for (std::size_t depth = 0; depth < depths_; ++depth) {
            RowPage& at = scratch_.rows.pages[depth];
            for (TileFloats TileColors::*channel : kChannels)
                for (std::size_t k = 0; k < csg::kTileRays; ++k)
                    (at.gained.*channel)[k] = (at.gained_before.*channel)[k] + (at.gained.*channel)[k];
        }
    }

    /// Works out sum(k): the light of all layers as the viewer sees it.
    void finish()
    {
        if (depths_ == 0) return;
        TileColors& sums = scratch_.rows.sums;
        const auto each = [&](TileFloats TileColors::*channel) {
            float* sum = (sums.*channel).data();
            for (std::size_t depth = 0; depth < depths_; ++depth) {
                const RowPage& at = scratch_.rows.pages[depth];
                each_part(count_, at.holds, [&](std::size_t i, FloatMask here) {
                    const FloatPart own = part(at.glow.*channel, i) + part(at.gained.*channel, i);
                    // The top layer's filter is 1.
                    const FloatPart all = depth == 0 ? own
                                                     : FloatPart::load_aligned(sum + i) +
                                                           here.kept(part(at.filter.*channel, i) * own);
                    all.store_aligned(sum + i);
                });
            }
        };
        each(&TileColors::red);
        each(&TileColors::green);
        each(&TileColors::blue);
    }
    glm::vec3 sum(std::size_t k) const { return scratch_.rows.sums[k]; }

    /// Gives the nodes of close_node() their light, once all lights have been added.
    void close_nodes(RayQueue& queue) const
    {
        for (const ClosingNode& of : scratch_.rows.closing) {
            glm::vec3& own = queue.nodes[of.node].own;
            for (std::uint32_t d = of.first; d < of.last; ++d) {
                const RowPage& at = scratch_.rows.pages[d];
                own += at.filter[of.hit] * (at.glow[of.hit] + at.gained[of.hit]);
            }
        }
    }

    /// Pages of rows in use.
    std::size_t depths() const { return depths_; }
    /// The normal of row `depth` of hit k, turned to the viewer.
    glm::dvec3 normal(std::size_t depth, std::size_t k) const
    {
        const RowPage& at = scratch_.rows.pages[depth];
        return has(at.bent, k) ? at.normal(k) : scratch_.hits.normal(k);
    }

    /// Adds the light of the rows that go through the lights one by one. place(k): where hit k lies; samples(k): the
    /// light that arrives there, by light.
    template <class PlaceOf, class SamplesOf>
    void add_scalar(PlaceOf&& place, SamplesOf&& samples)
    {
        for_each_hit(scalar_, [&](std::size_t k) {
            std::uint32_t grains = 0;
            for (std::uint32_t d = 0; d < rows_[k]; ++d) {
                RowPage& at = scratch_.rows.pages[d];
                if (!has(at.scalar, k)) continue;
                const glm::dvec3 normal = has(at.bent, k) ? at.normal(k) : scratch_.hits.normal(k);
                at.gained.set(k, direct_light(context_, {place(k), *at.finish[k], at.scalar_pigment.at(k), normal,
                                                         static_cast<double>(at.alpha[k]), samples(k), grains}));
                tell<&Recorder::scalar_row>(scratch_, d, k);
            }
        });
    }

private:
    /// Notes that these hits have rows.
    void hold(HitMask hits) { holds_ |= hits; }

    /// These hits have normals of their own on the page; others there keep the surface's.
    void own_normals(RowPage& at, HitMask hits)
    {
        if (at.bent == 0) {
            at.nx = scratch_.hits.nx;
            at.ny = scratch_.hits.ny;
            at.nz = scratch_.hits.nz;
        }
        at.bent |= hits;
        bent_ |= hits;
    }

    /// Page d, opened if it is the first after those in use.
    RowPage& page(std::size_t d)
    {
        if (d == scratch_.rows.pages.size()) scratch_.rows.pages.emplace_back();
        RowPage& at = scratch_.rows.pages[d];
        if (d == depths_) {
            ++depths_;
            at.holds = at.bent = at.scalar = at.lit = at.shiny = at.grainy = at.raised = at.tinted = 0;
            at.gained.fill(glm::vec3(0), count_);
            if (d == 0) at.filter.fill(glm::vec3(1), count_);
        }
        return at;
    }

    void set_kind(RowPage& at, HitMask hits, const texture::Finish& finish) const
    {
        if (finish.diffuse > 0.0f) at.lit |= hits;
        if ((finish.phong > 0.0f || finish.specular > 0.0f) && context_.bounce == 0) at.shiny |= hits;
        if (finish.brilliance != 1.0f) at.raised |= hits;
        if (finish.metallic > 0.0f) at.tinted |= hits;
        if (finish.crand > 0.0f) at.grainy |= hits;
    }

    RowPage& add_layer(std::size_t depth, HitMask hits, const texture::Layer& of)
    {
        RowPage& at = add_finish(depth, hits, of);
        if (of.normal != texture::kNone) {
            own_normals(at, hits);
            scratch_.rows.bends[bends_++] = {hits, of.normal, static_cast<std::uint8_t>(depth)};
        }
        return at;
    }

    RowPage& add_finish(std::size_t depth, HitMask hits, const texture::Layer& of)
    {
        RowPage& at = page(depth);
        const texture::Finish& finish = set_.finishes[of.finish];
        const glm::vec3 emitted = finish.ambient + finish.emission;
        const bool shiny = finish.phong > 0.0f || finish.specular > 0.0f;
        if (at.holds == 0 && !few(hits)) {  // places that other hits take are written again
            at.finish.fill(&finish);
            at.emitted.fill(emitted, csg::kTileRays);
            at.finish_diffuse.fill(finish.diffuse);
            if (shiny) at.lobe.fill(finish);
        } else {
            for_each_hit(hits, [&](std::size_t k) {
                at.finish[k] = &finish;
                at.emitted.set(k, emitted);
                at.finish_diffuse[k] = finish.diffuse;
                if (shiny) at.lobe.set(k, finish);
            });
        }
        at.holds |= hits;
        set_kind(at, hits, finish);
        return at;
    }

    /// Bends the normals of a layer's hits; they are unit vectors afterwards.
    void bend(const Bend& of)
    {
        RowPage& at = scratch_.rows.pages[of.depth];
        bend_normals(set_, of.normal, of.hits, scratch_, at.nx, at.ny, at.nz);
    }

    /// Takes the pigments of hits. Those in `clear` are dimmed by their opacity, the others count as opaque.
    void color(RowPage& at, HitMask hits, HitMask clear, const texture::ColorPoints& c)
    {
        tell<&Recorder::pigments>(scratch_, at, hits, clear, c);
        color_rows(at, {hits, clear, set_.legacy_opacity, context_.indirect != nullptr}, c);
    }

    /// A dull layer that is wholly clear shows no light, so no lamp is asked for it.
    [[gnu::noinline]] void drop_clear(HitMask hits, const texture::ColorPoints& c)
    {
        for_each_hit(hits, [&](std::size_t k) {
            if (texture::opacity(c.at(k), set_.legacy_opacity) == 0.0f) lit_ &= ~(HitMask{1} << k);
        });
    }

    Context& context_;
    const int count_;
    const texture::TextureSet& set_;
    ShadeScratch& scratch_;
    HitMask holds_ = 0, goes_on_ = 0, dull_ = 0, alone_ = 0, bent_ = 0, two_sided_ = 0, scalar_ = 0, lit_ = 0,
            reached_ = 0, dark_ = 0;
    std::array<std::uint16_t, csg::kTileRays> rows_;
    std::array<std::uint32_t, csg::kTileRays> grains_;  ///< asked for so far, of hits whose only row has some
    std::size_t depths_ = 0, bends_ = 0;
};

}  // namespace trace
