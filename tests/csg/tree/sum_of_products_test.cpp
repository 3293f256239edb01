#include "csg/items/world_data.h"
#include "csg/world/world.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <memory>
#include <vector>

using namespace csg;
using csg_test::Object;
using csg_test::Rng;

namespace {

Solid lattice_solid(Rng& rng)
{
    const auto whole = [&] { return 0.25 * rng.below(9) - 1.0; };
    if (rng.coin()) return Sphere{{whole(), whole(), whole()}, 1.0};
    const double z = whole();
    return Box{{-1.0, whole() - 1.0, z}, {1.0, 1.0, z + 0.25 * (1 + rng.below(4))}};
}

Solid any_solid(Rng& rng)
{
    const glm::dvec3 c = rng.point(1.0);
    switch (rng.below(7)) {
    case 0: return Sphere{c, rng.uniform(0.3, 1.2)};
    case 1: return Box{c, c + rng.uniform(0.2, 1.5)};
    case 2: return OrientedBox{{-0.8, -0.6, -0.7}, {0.7, 0.5, 0.9}, csg_test::random_transform(rng)};
    case 3: return Plane{rng.direction(), rng.uniform(-0.5, 1.0)};
    case 4: return Cylinder::make(c, -c, rng.uniform(0.2, 0.8), false, {});
    case 5: return Torus{0.8, rng.uniform(0.1, 0.4), csg_test::random_transform(rng)};
    default:
        return Quadric{{1, rng.uniform(-1, 1), 1}, {0.1, 0.2, 0}, {0, 0, 0}, -0.5, csg_test::random_transform(rng)};
    }
}

template <class Make>
Tree tree_of(Rng& rng, SolidStore& store, int depth, Make&& make)
{
    Tree made;
    if (depth == 0 || rng.below(4) == 0) {
        made.solid = store.add(make(rng), 0);
        return made;
    }
    made.op = static_cast<Tree::Op>(1 + rng.below(4));
    const int operands = 2 + rng.below(3);
    for (int i = 0; i < operands; ++i) made.operands.push_back(tree_of(rng, store, depth - 1, make));
    return made;
}

struct Tally {
    int usable = 0, found = 0, crossed = 0, asked = 0;
};

bool before(const Hit& a, const Hit& b)
{
    return a.t != b.t ? a.t < b.t : a.part != b.part ? a.part < b.part : a.face < b.face;
}

RayTile tile_past(Rng& rng, bool along_axis)
{
    RayTile tile{};
    tile.count = kTileRays;
    tile.common_origin = !along_axis && rng.coin();
    const Ray middle = csg_test::ray_near(rng, {0, 0, 0}, 1.2, 4.0);
    for (std::size_t k = 0; k < kTileRays; ++k) {
        Ray ray = middle;
        if (along_axis) {
            ray = {{0.25 * rng.below(8) - 0.875, 0.25 * rng.below(8) - 0.875, -4.0}, {0.0, 0.0, 1.0}};
        } else {
            if (!tile.common_origin) ray.origin += 0.1 * rng.point(1.0);
            ray.direction = glm::normalize(ray.direction + 0.1 * rng.point(1.0));
        }
        tile.set(k, ray, k % 2 != 0 ? 1e-4 : rng.uniform(1.0, 6.0), k % 3 != 0 ? kInfinity : rng.uniform(2.0, 8.0));
    }
    return tile;
}

/// A world of one glass object.
struct OneObject {
    WorldData data;

    template <class MakeTree>
    explicit OneObject(MakeTree&& make)
    {
        data.add_program(build(make(data.store), data.store), 0, 0xff);
        data.surface_opaque.assign(1, 0);
        data.finish();
    }
    bool usable() const { return !data.items.empty() && data.items[0].simple; }
    const Program& program() const { return data.programs[data.items[0].program]; }
};

/// What a tile is told of an object with a flat form is what the general evaluation tells of each ray.
void compare(const OneObject& object, Rng& rng, bool along_axis, Tally& tally)
{
    if (!object.usable()) return;
    ++tally.usable;
    const World world(object.data);
    const RayTile tile = tile_past(rng, along_axis);
    Scratch scratch, other;
    const auto nearest = std::make_unique<HitTile>();
    const auto crossings = std::make_unique<CrossingTile>();
    world.nearest(tile, 1, scratch, *nearest);
    world.shadow_crossings(tile, scratch, *crossings);
    for (std::size_t k = 0; k < kTileRays; ++k) {
        INFO("ray " << k);
        ++tally.asked;
        const Ray ray = tile.ray(static_cast<int>(k));
        const SolidStore& store = object.data.store;
        const Crossing expected =
            Evaluation(object.program(), store, ray, tile.t_min[k], tile.t_max[k], other).nearest();
        const Hit hit = nearest->at(static_cast<int>(k));
        REQUIRE(hit.found() == (expected.part != kNoPart));
        if (hit.found()) {
            ++tally.found;
            REQUIRE(hit.t == expected.t);
            REQUIRE(hit.part == expected.part);
            REQUIRE(hit.face == expected.face);
            REQUIRE(hit.inverted == expected.inverted);
        }
        if (crossings->count[k] == CrossingTile::kTooMany) continue;
        const auto [begin, end] = visible_crossings(object.program(), store, ray, tile.t_min[k], tile.t_max[k], other);
        std::vector<Hit> told(crossings->hits[k].begin(), crossings->hits[k].begin() + crossings->count[k]), general;
        for (const Crossing* c = begin; c != end; ++c) general.push_back({c->t, 0, c->part, c->face, c->inverted});
        std::sort(told.begin(), told.end(), before);
        std::sort(general.begin(), general.end(), before);
        REQUIRE(told.size() == general.size());
        for (std::size_t i = 0; i < told.size(); ++i) {
            ++tally.crossed;
            REQUIRE(told[i].t == general[i].t);
            REQUIRE(told[i].part == general[i].part);
        }
    }
}

/// A tile past each of 3000 random trees of solids that `make` gives.
template <class Make>
Tally compare_trees(Make&& make, int deepest, bool along_axis)
{
    Tally tally;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(csg_test::share(3000)); ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const OneObject object([&](SolidStore& store) { return tree_of(rng, store, 1 + rng.below(deepest), make); });
        compare(object, rng, along_axis, tally);
    }
    return tally;
}

}  // namespace

TEST_CASE("the flat form answers as the general evaluation does", "[csg][products]")
{
    const Tally tally = compare_trees(any_solid, 3, false);
    CHECK(tally.usable > csg_test::share(500));
    CHECK(tally.found > csg_test::share(10000));
    CHECK(tally.crossed > csg_test::share(10000));
}

TEST_CASE("where faces coincide the flat form gives up rather than guess", "[csg][products]")
{
    const Tally tally = compare_trees(lattice_solid, 2, true);
    CHECK(tally.found > csg_test::share(10000));
}

TEST_CASE("of many cuts those are asked that rays come near", "[csg][products]")
{
    Rng rng(7);
    const OneObject object([&](SolidStore& store) {
        Tree tree{.op = Tree::Op::Difference};
        tree.operands.push_back(Tree::leaf(store.add(Box{{-1, -1, -1}, {1, 1, 1}}, 0)));
        for (int i = 0; i < 300; ++i)
            tree.operands.push_back(Tree::leaf(store.add(Sphere{rng.point(1.0), rng.uniform(0.03, 0.2)}, 0)));
        return tree;
    });
    REQUIRE(object.usable());
    REQUIRE(object.program().products.cuts.size() > 200);
    Tally tally;
    for (int tile = 0; tile < 50; ++tile) compare(object, rng, false, tally);
    CHECK(tally.found > 1000);
}

TEST_CASE("what has no flat form says so", "[csg][products]")
{
    Object o;
    const PartId sphere = o.store.add(Sphere{{0, 0, 0}, 1});
    const PartId disc = o.store.add(Disc{});
    Tree with_disc{.op = Tree::Op::Intersection};
    with_disc.operands = {Tree::leaf(sphere), Tree::leaf(disc)};
    CHECK_FALSE(build(with_disc, o.store).products.usable());
    Tree merge{.op = Tree::Op::Merge};
    merge.operands = {Tree::leaf(sphere), Tree::leaf(o.store.add(Sphere{{0.5, 0, 0}, 1}))};
    CHECK(build(merge, o.store).products.merged);
    Tree cut{.op = Tree::Op::Difference};
    cut.operands = {Tree::leaf(o.store.add(Box{{-1, -1, -1}, {1, 1, 1}})), merge};
    CHECK(build(cut, o.store).products.usable());
    Tree within{.op = Tree::Op::Intersection};
    within.operands = {merge, Tree::leaf(o.store.add(Box{{-1, -1, -1}, {1, 1, 1}}))};
    CHECK_FALSE(build(within, o.store).products.usable());
}
