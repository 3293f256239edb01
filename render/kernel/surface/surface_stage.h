#pragma once

#include "render/kernel/light/direct_batch.h"
#include "render/kernel/light/bent_normals.h"
#include "render/kernel/extensions/ink_lines.h"
#include "render/kernel/surface/prefetch_pigments.h"
#include "render/kernel/context/segment_tile.h"
#include "render/kernel/scatter/scatter_lanes.h"
#include "render/kernel/surface/shade_surface.h"
#include "render/kernel/surface/texture_maps.h"
#include "render/kernel/scatter/scatter.h"

/// From the hits of a tile to rows of light, and to the rays that go on.
namespace trace {

class SurfaceStage {
public:
    /// dimmed: segments that ShadeScratch::air changes.
    SurfaceStage(Context& context, const SegmentTile& tile, DirectBatch& batch, HitMask dimmed)
        : context_(context), scratch_(context.scratch.shade), own_(scratch_.surface()), tile_(tile), batch_(batch),
          dimmed_(dimmed), together_(context, tile, batch)
    {}

    void run()
    {
        const plan::Settings& settings = context_.scene.settings;
        lights_ = settings.quality.lights;
        goes_on_ = settings.quality.reflection && context_.adc_bailout < 1.0;
        own_.pigments.clear();
        own_.layered_count = own_.mapped_count = 0;
        for (HitMask left = tile_.found(); left != 0;) {
            const csg::SurfaceId surface = tile_.hits.surface[first_hit(left)];
            const HitMask group = left & numbers::lanes::equal(tile_.hits.surface, surface);
            const plan::SurfaceTraits& traits = context_.traits.surfaces[surface];
            begin(group & ~tile_.from_inside(), surface, traits.outer, traits.outer_patterned);
            begin(group & tile_.from_inside(), surface, traits.inner, traits.inner_patterned);
            left &= ~group;
        }
        own_.pigments.run(context_.scene.textures,
                          [this](HitMask hits, const texture::ColorPoints& colors) { batch_.color(hits, colors); });
        if (layered_) finish_layers();
        if (own_.mapped_count != 0) look_up_maps();
        batch_.bend();
        if (context_.scene.textures.extensions.empty()) together_.prepare(batch_.all() & ~batch_.all_alone());
        for_each_hit(tile_.found() & ~batch_.all_alone(), [&](std::size_t k) {
            if (together_.ready(k)) together_.send(k, slot(k));
            else go_on(k);
        });
    }

private:
    /// Hits on one side of a surface.
    void begin(HitMask group, csg::SurfaceId surface, const plan::SingleLayer& single,
               const plan::PatternedLayers& layers)
    {
        if (goes_on_ && single.clear)
            group &= ~together_.pass_through(group, context_.scene.surfaces[surface].interior);
        if (group == 0) return;
        if (lights_ && !context_.traits.scalar_rows && single.index != plan::kNone && (goes_on_ || !single.goes_on))
            begin_single(group, surface, single);
        else if (layers.texture != plan::kNone && !layers.map) begin_layers(group, surface, layers);
        else if (layers.texture != plan::kNone && !context_.traits.scalar_rows) begin_map(group, surface, layers);
    }

    void begin_single(HitMask group, csg::SurfaceId surface, const plan::SingleLayer& single)
    {
        const auto& set = context_.scene.textures;
        batch_.begin(group, single);
        const std::uint32_t index = set.layers[single.index].pigment;
        const texture::Pigment& pigment = set.pigments[index];
        const bool solid = pigment.kind == texture::Pigment::Kind::Solid;
        if (solid) {
            if (few(group)) for_each_hit(group, [&](std::size_t k) { own_.solid.set(k, pigment.color); });
            else own_.solid.fill(pigment.color);
            batch_.color(group, own_.solid);
        }
        if (solid && !batch_.bent(first_hit(group))) return;
        surround(group, surface);
        if (!solid) own_.pigments.ask(group, index, scratch_.patterns.points, scratch_.patterns.around);
    }

    void begin_layers(HitMask group, csg::SurfaceId surface, const plan::PatternedLayers& of)
    {
        layered_ |= group;
        surround(group, surface);
        const bool alone = of.alone && lights_ && !context_.traits.scalar_rows;
        if (own_.layered_count != 0) {  // both sides of a surface share their vectors
            LayeredGroup& last = own_.layered[own_.layered_count - 1];
            if (last.texture == of.texture && last.alone == alone) {
                last.hits |= group;
                return;
            }
        }
        own_.layered[own_.layered_count++] = {group, of.texture, alone};
    }

    void begin_map(HitMask group, csg::SurfaceId surface, const plan::PatternedLayers& of)
    {
        surround(group, surface);
        if (own_.mapped_count != 0) {
            MappedGroup& last = own_.mapped[own_.mapped_count - 1];
            if (last.texture == of.texture && last.alone == of.alone) {
                last.hits |= group;
                return;
            }
        }
        own_.mapped[own_.mapped_count++] = {group, of.texture, 0, of.alone, 0};
    }

    /// The hits as patterns see them.
    void surround(HitMask group, csg::SurfaceId surface)
    {
        const TileHits& places = scratch_.hits;
        const bool uv = context_.scene.surfaces[surface].uv_mapping;
        for_each_hit(group, [&](std::size_t k) {
            scratch_.patterns.points.set(k, uv ? glm::dvec3(scratch_.details[k].uv, 0.0) : places.point(k));
        });
        if (!context_.traits.surfaces[surface].looked_around) return;
        for_each_hit(group, [&](std::size_t k) {
            texture::Surroundings& around = scratch_.patterns.around[k];  // member by member, as the details
            around.point = places.point(k);
            around.normal = places.normal(k);
            around.direction = tile_.rays.ray(static_cast<int>(k)).direction;
            around.uv = has(tile_.batched(), k) ? glm::dvec2(0) : scratch_.details[k].uv;
            around.surface = true;
        });
    }

    /// Pigments of the layers, top down; hits whose layers hide what is behind them have all their rows then.
    void finish_layers()
    {
        const auto& set = context_.scene.textures;
        const auto bailout = static_cast<float>(context_.adc_bailout);
        const HitMask open = prefetch_pigments(scratch_, set, bailout);
        for (std::size_t g = 0; g < own_.layered_count; ++g) {
            const LayeredGroup& group = own_.layered[g];
            const HitMask hidden = group.alone ? group.hits & ~open : 0;
            const texture::Texture& texture = set.textures[group.texture];
            if (hidden != 0) batch_.begin(hidden, texture);
            bend(group.hits & ~hidden, texture);
        }
    }

    void look_up_maps()
    {
        own_.maps.clear();
        // Samples of light from elsewhere are placed by rows in POV-Ray's order, and so are rows told to a recorder.
        const bool lays_rows = lights_ && goes_on_ && context_.indirect == nullptr && scratch_.recorder == nullptr &&
                               context_.scene.textures.extensions.empty();
        for (std::size_t g = 0; g < own_.mapped_count; ++g) {
            MappedGroup& group = own_.mapped[g];
            texture::Points points, normals;
            texture::Around around;
            for_each_hit(group.hits, [&](std::size_t k) {
                around[points.size()] = &scratch_.patterns.around[k];
                points.add(scratch_.patterns.points.at(k));
                normals.add(scratch_.hits.normal(k));
            });
            points.pad();
            normals.pad();
            group.place = own_.maps.look_up(context_, group.texture, group.hits, points, around, normals);
            if (lays_rows && group.alone) group.mixed = own_.maps.lay_rows(context_, batch_, group.place);
        }
    }

    /// Normals of the layers of hits that rays go on from.
    void bend(HitMask hits, const texture::Texture& of)
    {
        const auto& set = context_.scene.textures;
        for (std::uint32_t depth = 0; depth < of.count; ++depth) {
            const std::uint32_t normal = set.layers[of.first + of.count - 1 - depth].normal;
            const HitMask here = hits & scratch_.patterns.asked[depth];
            if (here == 0) return;
            if (normal == texture::kNone) continue;
            BentNormals& to = scratch_.patterns.layers[depth].normals;
            bend_normals(set, normal, here, scratch_, to.x.v, to.y.v, to.z.v);
        }
    }

    /// A hit that rays go on from, or whose textures are mixed.
    void go_on(std::size_t k)
    {
        const RayState& state = tile_.state(k);
        const Hit met = tile_.hits.at(static_cast<int>(k));
        RayQueue& queue = context_.scratch.shade.queue;
        const std::uint32_t texture = tile_.texture(k);
        if (texture == plan::kNone) {
            queue.colors[tile_.slot(k)] = has(dimmed_, k) ? scratch_.air[k]({}) : scene::Color();
            return;
        }
        if (!context_.scene.textures.extensions.empty() && on_ink_line(context_, tile_.place(k, state, met), texture)) {
            const scene::Color ink = scene::Color::of(glm::vec3(0));
            queue.colors[tile_.slot(k)] = has(dimmed_, k) ? scratch_.air[k](ink) : ink;
            return;
        }
        const ColorSlot out = slot(k);
        if (batch_.holds(k)) return go_on_single(tile_.place(k, state, met), k, out);
        HitContext hit = tile_.context(k, state, met);
        const HitDetails& details = tile_.details(k);
        hit.surround(details.point, details.uv);
        for (std::size_t g = 0; g < own_.mapped_count; ++g) {
            const MappedGroup& group = own_.mapped[g];
            if (has(group.hits, k))
                return own_.maps.shade(context_, batch_, hit, group.place, scratch_.patterns.points, k, out);
        }
        PrefetchedPigments prefetched;
        if (find_prefetched(k, prefetched) && prefetched.texture == texture) hit.prefetched = &prefetched;
        shade_surface(context_, batch_, hit, details, out);
    }

    /// A hit of one layer, whose row is there.
    void go_on_single(const HitPlace& hit, std::size_t k, ColorSlot out)
    {
        const texture::Finish& finish = batch_.top_finish(k);
        const scene::Color c = batch_.top_pigment(k);
        LayerStack stack(scratch_.mirrors);
        const glm::dvec3 normal = scratch_.hits.normal(k);  // hit.normal, which has just been written piece by piece
        stack.top_normal = normal;
        Mirror& mirror = stack.mirrors.emplace_back();
        find_mirror(context_, hit, finish, c, normal, stack.residual, mirror);
        stack.pass(c, finish, mirror.reflectivity);
        batch_.close_node(k, 0, scatter(context_, hit, stack, out));
    }

    /// Where the colour of hit k is to come, without the air before it.
    ColorSlot slot(std::size_t k)
    {
        return has(dimmed_, k) ? dim(scratch_.queue, scratch_.air[k], tile_.slot(k)) : tile_.slot(k);
    }

    /// A node for the air before the hit; the slot that it dims.
    static ColorSlot dim(RayQueue& queue, const Air& air, ColorSlot out)
    {
        const ColorSlot seen = queue.new_slot();
        ShadeNode& node = queue.new_node(ShadeNode::Kind::Air, out);
        node.through = seen;
        node.filter = air.share;
        node.own = air.glow;
        node.residual = air.clear;
        return seen;
    }

    /// Pigments of hit k that were looked up together with others'.
    bool find_prefetched(std::size_t k, PrefetchedPigments& out) const
    {
        if (!has(layered_, k)) return false;
        for (std::size_t g = 0; g < own_.layered_count; ++g) {
            const LayeredGroup& group = own_.layered[g];
            if (has(group.hits, k))
                out = {group.texture, context_.scene.textures.textures[group.texture].count,
                       scratch_.patterns.layers.data(), k};
        }
        return true;
    }

    Context& context_;
    ShadeScratch& scratch_;
    SurfaceScratch& own_;
    const SegmentTile& tile_;
    DirectBatch& batch_;
    bool lights_ = false, goes_on_ = false;  ///< of this quality
    HitMask dimmed_;
    HitMask layered_ = 0;  ///< hits with prefetched pigments
    LaneScatter together_;
};

/// The colours of hits whose texture maps have all their rows, in the place of the sums of these, once all lights have
/// been added.
inline void mix_maps(const Context& context)
{
    const SurfaceScratch& own = context.scratch.shade.surface();
    TileColors colors;
    for (std::size_t g = 0; g < own.mapped_count; ++g) {
        const MappedGroup& group = own.mapped[g];
        if (group.mixed == 0) continue;
        own.maps.mix(context, group.place, colors);
        for_each_hit(group.mixed, [&](std::size_t k) { context.scratch.shade.rows.sums.set(k, colors[k]); });
    }
}

}  // namespace trace
