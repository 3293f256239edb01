#include "csg/world/world.h"
#include "csg/items/world_data.h"
#include "tests/csg/tree/walk_trees.h"

#include <catch2/catch.hpp>

#include <memory>
#include <vector>

using namespace csg;
using csg_test::Rng;
using csg_test::share;

namespace {

/// A world of one CSG object, opaque or not, and perhaps behind a guard that lets some of the rays through.
struct OneObject {
    WorldData data;

    OneObject(std::uint32_t seed, bool glass, bool guarded)
    {
        Rng rng(seed);
        const int depth = 1 + rng.below(3);
        const Tree tree = seed % 5 < 2 ? csg_test::tree_on_lattice(rng, data.store, depth)
                                       : csg_test::tree_for_walk(rng, data.store, depth);
        Program program = build(tree, data.store);
        data.add_program(std::move(program), 0, 0xff);
        if (guarded) {
            BoundingGuard guard;
            const glm::dvec3 corner = rng.point(0.5);
            guard.box = {corner - 0.3, corner + 0.3};
            guard.shadows_pass = rng.below(4) == 0;
            data.guard_last(std::move(guard));
        }
        data.surface_opaque.assign(1, glass ? 0 : 1);
        data.finish();
    }
    bool in_lanes() const { return !data.items.empty() && (data.items[0].boolean || data.items[0].simple); }
};

/// Rays past the object, close enough together for a beam; from one point or each from its own. In some tiles most of
/// them end before they are there, so that those that come to it lie scattered over the tile.
RayTile tile_past(Rng& rng)
{
    RayTile tile{};
    tile.count = kTileRays;
    tile.common_origin = rng.coin();
    const glm::dvec3 from = 4.0 * rng.direction() * (rng.below(4) == 0 ? 0.1 : 1.0), to = rng.point(0.7);
    const bool scattered = rng.below(3) == 0;
    for (std::size_t k = 0; k < kTileRays; ++k) {
        const glm::dvec3 origin = tile.common_origin ? from : from + 0.05 * rng.point(1.0);
        tile.set(k, {origin, glm::normalize(to + 0.15 * rng.point(1.0) - origin)}, rng.coin() ? 1e-4 : 2.5,
                 scattered && rng.below(4) != 0 ? 1e-3
                 : rng.below(3) == 0            ? rng.uniform(2.0, 6.0)
                                                : kInfinity);
    }
    return tile;
}

}  // namespace

TEST_CASE("a tile asks a boolean form in lanes as its rays do alone", "[csg][boolean]")
{
    int objects = 0, hits = 0, crossed = 0, behind_guards = 0, told_through = 0;
    Scratch scratch;
    const auto found = std::make_unique<HitTile>();
    const auto crossings = std::make_unique<CrossingTile>();
    std::vector<Hit> alone;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(share(3000)); ++seed) {
        INFO("seed " << seed);
        const bool glass = seed % 2 != 0;
        const bool guarded = seed % 3 == 0;
        const OneObject object(seed, glass, guarded);
        if (!object.in_lanes()) continue;
        ++objects;
        const World world(object.data);
        Rng rng(seed + 1000000);
        for (int round = 0; round < 2; ++round) {
            const RayTile tile = tile_past(rng);
            world.nearest(tile, 1, scratch, *found);
            Shadow shadows[kTileRays];
            world.shadow(tile, scratch, shadows);
            world.shadow_crossings(tile, scratch, *crossings);
            for (int i = 0; i < tile.count; ++i) {
                INFO("round " << round << ", ray " << i);
                const auto k = static_cast<std::size_t>(i);
                const Ray ray = tile.ray(i);
                const Hit hit = world.nearest(ray, tile.t_min[k], tile.t_max[k], 1, scratch), in_tile = found->at(i);
                REQUIRE(in_tile.found() == hit.found());
                behind_guards += guarded ? 1 : 0;
                if (hit.found()) {
                    ++hits;
                    told_through += guarded ? 1 : 0;
                    REQUIRE(in_tile.t == hit.t);
                    REQUIRE(in_tile.part == hit.part);
                    REQUIRE(in_tile.face == hit.face);
                    REQUIRE(in_tile.inverted == hit.inverted);
                }
                REQUIRE(shadows[k] == world.shadow(ray, tile.t_min[k], tile.t_max[k], scratch));
                const Shadow ending = world.shadow_crossings(ray, tile.t_min[k], tile.t_max[k], scratch, alone);
                REQUIRE(crossings->ending[k] == ending);
                if (ending != Shadow::Filtered || crossings->count[k] == CrossingTile::kTooMany) continue;
                REQUIRE(crossings->count[k] == alone.size());
                for (std::size_t c = 0; c < alone.size(); ++c) {
                    ++crossed;
                    REQUIRE(crossings->hits[k][c].t == alone[c].t);
                    REQUIRE(crossings->hits[k][c].part == alone[c].part);
                    REQUIRE(crossings->hits[k][c].face == alone[c].face);
                }
            }
        }
    }
    CHECK(objects > share(400));
    CHECK(hits > share(10000));
    CHECK(crossed > share(10000));
    CHECK(told_through > share(1000));
    CHECK(told_through < behind_guards / 2);
}
