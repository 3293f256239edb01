// World's questions for a tile of rays.
#include "csg/world/world.h"
#include "csg/items/depth_range.h"
#include "csg/packet/shaft.h"
#include "csg/packet/tile_clusters.h"
#include "csg/packet/tile_crossings.h"
#include "csg/items/instance_ray.h"

#include <algorithm>

namespace csg {

namespace {

/// Whether answered(TileRays) is: only enough rays make a beam.
template <class Answered>
inline bool in_lanes(const RayTile& rays, int fewest, Answered&& answered)
{
    if (rays.count < fewest) return false;
    return rays.common_origin ? answered(TileRays<SharedOrigin>(rays)) : answered(TileRays<OwnOrigins>(rays));
}

/// Shadow rays that are about as long as each other: as one beam if they can be.
void shadow_of_cluster(const World& world, const WorldData& data, const RayTile& rays, Scratch& scratch, Shadow* out)
{
    const auto answered = [&](auto&& lanes) {
        ShadowOfTile query(data, lanes, scratch);
        if (!ask_tile(data, lanes, data.shadow_kinds, query)) return false;
        for (int i = 0; i < rays.count; ++i) out[i] = query.answer(i);
        return true;
    };
    if (!data.faithful && in_lanes(rays, fewest_for_beam(data, rays), answered)) return;
    const auto together = [&](auto&& lanes) {
        ShadowOfTile query(data, lanes, scratch);
        ask_packet(data, lanes, data.shadow_kinds, query);
        for (int i = 0; i < rays.count; ++i) out[i] = query.answer(i);
        return true;
    };
    if (!data.faithful && in_lanes(rays, fewest_for_packet(data, rays), together)) return;
    for (int i = 0; i < rays.count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        out[i] = world.shadow(rays.ray(i), rays.t_min[k], rays.t_max[k], scratch);
    }
}

void crossings_of_cluster(const World& world, const WorldData& data, const RayTile& rays, Scratch& scratch,
                          CrossingTile& out)
{
    const auto answered = [&](auto&& lanes) {
        CrossingsOfTile query(data, lanes, scratch, out);
        if (!ask_tile(data, lanes, data.shadow_kinds, query)) return false;
        query.finish();
        return true;
    };
    if (!data.faithful && in_lanes(rays, fewest_for_beam(data, rays), answered)) return;
    const auto together = [&](auto&& lanes) {
        CrossingsOfTile query(data, lanes, scratch, out);
        ask_packet(data, lanes, data.shadow_kinds, query);
        query.finish();
        return true;
    };
    if (!data.faithful && in_lanes(rays, fewest_for_packet(data, rays), together)) return;
    std::vector<Hit>& hits = scratch.hits();
    for (int i = 0; i < rays.count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        out.ending[k] = world.shadow_crossings(rays.ray(i), rays.t_min[k], rays.t_max[k], scratch, hits);
        const bool fits = hits.size() <= CrossingTile::kMost;
        out.count[k] = fits ? static_cast<std::uint8_t>(hits.size()) : CrossingTile::kTooMany;
        if (fits) std::copy(hits.begin(), hits.end(), out.hits[k].begin());
    }
}

void turn_into(const Instance& one, RayTile& rays, std::array<double, kTileRays>& length)
{
    for (int i = 0; i < rays.count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const LocalRay local(one, rays.ray(i));
        length[k] = local.length;
        rays.set(k, local.ray, rays.t_min[k] * local.length, rays.t_max[k] * local.length);
    }
}

}  // namespace

void instance_nearest(const WorldData& world, const WorldItem& item, RayTile& rays, Scratch& scratch, HitTile& out)
{
    std::array<double, kTileRays> length;
    const std::array<double, kTileRays> from = rays.t_min, to = rays.t_max;
    turn_into(world.instances[item.instance], rays, length);
    World(*world.instances[item.instance].world).nearest(rays, 0xff, scratch, out);
    for (int i = 0; i < rays.count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (out.surface[k] != kNoSurface) out.set(i, here(world, item, length[k], out.at(i), from[k], to[k]));
    }
}

void instance_shadow(const WorldData& world, const WorldItem& item, RayTile& rays, Scratch& scratch, Shadow* out)
{
    std::array<double, kTileRays> length;
    turn_into(world.instances[item.instance], rays, length);
    World(*world.instances[item.instance].world).shadow(rays, scratch, out);  // where all is opaque
}

// Never a part of what calls it: tests/lean count instructions by its name.
[[gnu::noinline]] void World::nearest(const RayTile& rays, std::uint8_t kind_bit, Scratch& scratch, HitTile& out) const
{
    scratch.cancel.look();
    const auto ask = [&](auto&& lanes, bool beam) {
        NearestOfTile query(*data_, lanes, scratch, out);
        if (!beam) ask_packet(*data_, lanes, kind_bit, query);
        else if (!ask_tile(*data_, lanes, kind_bit, query)) return false;
        query.finish();
        const RayMask tied = data_->test_order ? query.tied() : 0;
        each_ray(tied, [&](std::size_t k) {
            const int i = static_cast<int>(k);
            out.set(i, first_tested(rays.ray(i), rays.t_min[k], kind_bit, scratch, out.at(i), query.tie(k)));
        });
        if (!data_->ordered.empty()) {
            for (int i = 0; i < rays.count; ++i) {
                const auto k = static_cast<std::size_t>(i);
                if (out.surface[k] == kNoSurface || (tied >> k & 1u) != 0 ||
                    !before_box(*data_, query.item(k), rays.ray(i), rays.t_min[k], out.t[k]))
                    continue;
                out.set(i, first_in_order(rays.ray(i), rays.t_min[k], rays.t_max[k], kind_bit, scratch));
            }
        }
        return true;
    };
    const auto answered = [&](auto&& lanes) { return ask(lanes, true); };
    const auto together = [&](auto&& lanes) { return ask(lanes, false); };
    const int fewest = fewest_for_beam(*data_, rays);
    if (in_lanes(rays, fewest, answered)) {
        if (data_->faithful) recheck(rays, kind_bit, scratch, out);
        return;
    }
    if (in_lanes(rays, fewest_for_packet(*data_, rays), together)) {
        if (data_->faithful) recheck(rays, kind_bit, scratch, out);
        return;
    }
    // Too far apart for one beam: perhaps not for several.
    const TileClusters clusters = rays.count < 2 * fewest ? TileClusters() : TileClusters::by_direction(rays);
    if (clusters.size() == 1) {
        for (int i = 0; i < rays.count; ++i) {
            const auto k = static_cast<std::size_t>(i);
            out.set(i, nearest(rays.ray(i), rays.t_min[k], rays.t_max[k], kind_bit, scratch));
        }
        return;
    }
    RayTile part;
    HitTile found;
    std::uint8_t place[kTileRays];
    for (int c = 0; c < clusters.size(); ++c) {
        clusters.part(rays, c, part, place);
        nearest(part, kind_bit, scratch, found);
        for (int i = 0; i < part.count; ++i) out.set(place[i], found.at(i));
    }
}

void World::recheck(const RayTile& rays, std::uint8_t kind_bit, Scratch& scratch, HitTile& out) const
{
    for (int i = 0; i < rays.count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const Hit hit = out.at(i);
        if (hit.found() && !depth_range_of(*data_, hit).holds(hit.t))
            out.set(i, first_in_reach(rays.ray(i), rays.t_min[k], rays.t_max[k], kind_bit, scratch));
    }
}

void World::shadow(const RayTile& rays, Scratch& scratch, Shadow* out) const
{
    scratch.cancel.look();
    const TileClusters clusters = TileClusters::by_distance(rays);
    if (clusters.size() == 1) {
        shadow_of_cluster(*this, *data_, rays, scratch, out);
        return;
    }
    RayTile part;
    std::uint8_t place[kTileRays];
    Shadow answers[kTileRays];
    for (int c = 0; c < clusters.size(); ++c) {
        clusters.part(rays, c, part, place);
        shadow_of_cluster(*this, *data_, part, scratch, answers);
        for (int i = 0; i < part.count; ++i) out[place[i]] = answers[i];
    }
}

void World::shadow_crossings(const RayTile& rays, Scratch& scratch, CrossingTile& out) const
{
    scratch.cancel.look();
    const TileClusters clusters = TileClusters::by_distance(rays);
    if (clusters.size() == 1) {
        crossings_of_cluster(*this, *data_, rays, scratch, out);
        return;
    }
    out.count.fill(0);
    RayTile part;
    CrossingTile found;
    std::uint8_t place[kTileRays];
    for (int c = 0; c < clusters.size(); ++c) {
        clusters.part(rays, c, part, place);
        crossings_of_cluster(*this, *data_, part, scratch, found);
        for (int i = 0; i < part.count; ++i) out.ending[place[i]] = found.ending[static_cast<std::size_t>(i)];
        const auto* const endings = reinterpret_cast<const std::uint8_t*>(found.ending.data());
        const RayMask all = part.count < kTileRays ? (RayMask{1} << part.count) - 1 : ~RayMask{0};
        each_ray(all & lanes::equal(endings, static_cast<std::uint8_t>(Shadow::Filtered)), [&](std::size_t i) {
            out.count[place[i]] = found.count[i];
            if (found.count[i] <= CrossingTile::kMost)
                std::copy_n(found.hits[i].begin(), found.count[i], out.hits[place[i]].begin());
        });
    }
}

void World::shadow(const RayTile& rays, const Shaft& shaft, Scratch& scratch, Shadow* out) const
{
    scratch.cancel.look();
    TileRays<OwnOrigins> lanes(rays);
    ShadowOfTile query(*data_, lanes, scratch);
    shaft.ask(*data_, lanes, query);
    for (int i = 0; i < rays.count; ++i) out[i] = query.answer(i);
}

void World::shadow_crossings(const RayTile& rays, const Shaft& shaft, Scratch& scratch, CrossingTile& out) const
{
    scratch.cancel.look();
    TileRays<OwnOrigins> lanes(rays);
    CrossingsOfTile query(*data_, lanes, scratch, out);
    shaft.ask(*data_, lanes, query);
    query.finish();
}

}  // namespace csg
