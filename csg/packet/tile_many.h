#pragma once

#include "csg/packet/merged_ends.h"
#include "csg/packet/lanes/tile_rays.h"
#include "csg/items/world_item.h"

/// Rays of a tile that a solid answers together.
namespace csg {

/// For a TileLeaf and its Query.
template <class Rays, class Query>
struct TileMany {
    const WorldData& world;
    Rays& rays;
    Query& query;

    template <class Solid>
    const RayBatch& told_of(const Solid& solid, RayMask asked, bool first_only) const
    {
        return told_of(solid, asked, first_only, [](const Ray&, Stretch&) { return true; });
    }

    /// narrow(ray, range): to what the solid is asked for. False: for nothing.
    template <class Solid, class Narrow>
    const RayBatch& told_of(const Solid& solid, RayMask asked, bool first_only, Narrow&& narrow) const
    {
        RayBatch& batch = query.scratch().batch();
        each_ray(asked, [&](std::size_t k) {
            if (rays.limit[k] < 0.0) return;
            const Ray ray = rays.ray(static_cast<int>(k));
            Stretch part{rays.t_min[k], rays.limit[k]};
            if (narrow(ray, part)) batch.add(ray, k, part.from, part.to, first_only);
        });
        solid.intersect_many(batch);
        return batch;
    }

    bool serves_merged(const WorldItem& item) const
    {
        return !item.boolean && !world.programs[item.program].merged.empty() && query.first_only(item);
    }

    /// A merge of many solids, by their drawn ends. Returns the rays that remain to be asked otherwise.
    [[gnu::noinline]] RayMask by_merged(std::uint32_t index, RayMask mask) const
    {
        const Program& program = world.programs[world.items[index].program];
        MergedEnds ends(program, world.store, query.scratch().merged_ends());
        for (std::uint32_t s = 0; s < program.merged.size(); ++s) {
            const MergedSolid& of = program.merged[s];
            const RayMask asked = rays.intersect(of.drawn.lower, of.drawn.upper, mask);
            if (asked == 0) continue;
            const PartId part = program.nodes[of.node].solid;
            const auto offer = [&](std::size_t k, double t, std::uint32_t face) {
                if (t >= rays.t_min[k] && t <= rays.limit[k] && face != kUndrawnFace && t < kInfinity)
                    ends.add(k, s, t, face);
            };
            with_solid(world.store, part, [&](const auto& solid) {
                if constexpr (std::is_same_v<std::decay_t<decltype(solid)>, Freeform>) {
                    const RayBatch& batch = told_of(solid, asked, false);
                    for (std::size_t i = 0; i < batch.count; ++i)
                        batch.records[i].each_span(
                            [&](double in, std::uint32_t in_face, double out, std::uint32_t out_face) {
                                offer(batch.place[i], in, in_face);
                                offer(batch.place[i], out, out_face);
                            });
                } else {
                    each_ray(asked, [&](std::size_t k) {
                        const Ray ray = rays.ray(static_cast<int>(k));
                        each_span_of(solid, ray, false, rays.t_min[k], rays.limit[k], origin_reach(ray),
                                     {world.store, program.nodes.data(), of.node, {}},
                                     query.scratch().leaf_spans(program.nodes[of.node].max_spans),
                                     [&](double in, std::uint32_t in_face, double out, std::uint32_t out_face) {
                                         offer(k, in, in_face);
                                         offer(k, out, out_face);
                                     });
                    });
                }
            });
        }
        RayMask unclear = 0;
        each_ray(mask, [&](std::size_t k) {
            Crossing seen;
            const auto answer = rays.limit[k] < 0.0 ? MergedEnds::Answer::Nothing
                                                    : ends.nearest(k, rays.ray(static_cast<int>(k)), seen);
            if (answer == MergedEnds::Answer::Seen) query.hit(index, k, hit_of(world.store, seen));
            else if (answer == MergedEnds::Answer::Unclear) unclear |= RayMask{1} << k;
        });
        return unclear;
    }
};

}  // namespace csg
