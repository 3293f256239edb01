#include "tests/render/trace/random_world.h"

#include "csg/freeform/freeform.h"
#include "csg/items/world_item.h"
#include "csg/world/inside_index.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <memory>

using random_world::Rng;

namespace {

constexpr std::uint8_t kImage = 1, kShadow = 4;

/// The answer that needs no hierarchy: every item in turn, the first of the nearest.
csg::Hit by_force(const csg::WorldData& world, const csg::Ray& ray, double t_min, double t_max, csg::Scratch& scratch)
{
    csg::Hit best;
    for (const csg::WorldItem& item : world.items) {
        if ((item.visible & kImage) == 0) continue;
        const csg::Hit hit = csg::item_nearest(world, item, ray, t_min, t_max, scratch);
        if (hit.found() && hit.t < best.t) best = hit;
    }
    return best;
}

csg::Shadow shadow_by_force(const csg::WorldData& world, const csg::Ray& ray, double t_min, double t_max,
                            csg::Scratch& scratch)
{
    csg::Shadow found = csg::Shadow::Clear;
    for (const csg::WorldItem& item : world.items) {
        if ((item.visible & kShadow) == 0) continue;
        csg::item_crossings(world, item, ray, t_min, t_max, scratch, nullptr, [&](const csg::Hit& hit) {
            if (world.surface_opaque[hit.surface] != 0) found = csg::Shadow::Blocked;
            else if (found == csg::Shadow::Clear) found = csg::Shadow::Filtered;
        });
    }
    return found;
}

void check_same(const csg::Hit& a, const csg::Hit& b)
{
    REQUIRE(a.found() == b.found());
    if (!a.found()) return;
    REQUIRE(a.t == b.t);
    REQUIRE(a.surface == b.surface);
    REQUIRE(a.part == b.part);
    REQUIRE(a.face == b.face);
    REQUIRE(a.inverted == b.inverted);
}

csg::Ray random_ray(Rng& rng)
{
    csg::Ray ray{rng.point(15.0), rng.direction()};
    if (rng.below(8) == 0) {  // along an axis: zero components
        ray.direction = glm::dvec3(0.0);
        ray.direction[static_cast<int>(rng.below(3))] = rng.below(2) == 0 ? 1.0 : -1.0;
    }
    return ray;
}

/// Rays from one point through an 8x8 grid of a picture, as a camera makes them.
csg::RayTile camera_tile(Rng& rng, double spread)
{
    csg::RayTile tile{};
    const glm::dvec3 eye = rng.point(20.0), towards = glm::normalize(rng.point(6.0) - eye);
    const glm::dvec3 right = glm::normalize(glm::cross(towards, glm::dvec3(0.3, 1.0, 0.2))),
                     up = glm::cross(right, towards);
    tile.common_origin = true;
    tile.count = rng.below(4) == 0 ? 1 + static_cast<int>(rng.below(64)) : 64;
    for (int i = 0; i < tile.count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const glm::dvec3 d = glm::normalize(towards + spread * (i % 8 - 3.5) * right + spread * (i / 8 - 3.5) * up);
        tile.ox[k] = eye.x, tile.oy[k] = eye.y, tile.oz[k] = eye.z;
        tile.dx[k] = d.x, tile.dy[k] = d.y, tile.dz[k] = d.z;
        tile.t_min[k] = 1e-4;
        tile.t_max[k] = rng.below(3) == 0 ? rng.uniform(1.0, 30.0) : numbers::kInfinity;
    }
    return tile;
}

/// Rays from points of their own, as mirrors and glass send them on: some start inside a solid.
csg::RayTile onward_tile(Rng& rng, double spread)
{
    csg::RayTile tile = camera_tile(rng, spread);
    tile.common_origin = false;
    const glm::dvec3 away = rng.point(12.0);
    const double apart = (rng.below(2) == 0) ? 1.0 : 0.02;
    for (std::size_t k = 0; k < static_cast<std::size_t>(tile.count); ++k) {
        const glm::dvec3 from = away + apart * rng.point(1.0);
        tile.ox[k] = from.x, tile.oy[k] = from.y, tile.oz[k] = from.z;
    }
    return tile;
}

/// Rays that fly apart, from few to all: no beam holds them.
csg::RayTile scattered_tile(Rng& rng)
{
    csg::RayTile tile = onward_tile(rng, 0.05);
    tile.common_origin = rng.below(4) == 0;
    tile.count = 1 + static_cast<int>(rng.below(64));
    for (std::size_t k = 0; k < static_cast<std::size_t>(tile.count); ++k) {
        csg::Ray ray = random_ray(rng);
        if (tile.common_origin) ray.origin = tile.ray(0).origin;
        tile.set(k, ray, 1e-4, rng.below(3) == 0 ? rng.uniform(1.0, 30.0) : numbers::kInfinity);
    }
    return tile;
}

csg::RayTile any_tile(Rng& rng, int k)
{
    if (k % 4 == 1) return scattered_tile(rng);
    const double spread = k % 3 == 0 ? 0.05 : 0.003;
    return (rng.below(2) == 0) ? camera_tile(rng, spread) : onward_tile(rng, k % 5 == 0 ? 0.15 : spread);
}

/// World::nearest() and World::shadow() of tiles against those of their rays; how many met something.
int check_tiles(const csg::WorldData& data, Rng& rng, int count)
{
    const csg::World world(data);
    csg::Scratch scratch;
    int met = 0;
    for (int k = 0; k < count; ++k) {
        const csg::RayTile tile = any_tile(rng, k);
        const auto hits = std::make_unique<csg::HitTile>();
        world.nearest(tile, kImage, scratch, *hits);
        csg::Shadow shadows[csg::kTileRays];
        world.shadow(tile, scratch, shadows);
        for (int i = 0; i < tile.count; ++i) {
            INFO("tile " << k << " ray " << i);
            const auto at = static_cast<std::size_t>(i);
            check_same(hits->at(i), world.nearest(tile.ray(i), tile.t_min[at], tile.t_max[at], kImage, scratch));
            REQUIRE(shadows[i] == world.shadow(tile.ray(i), tile.t_min[at], tile.t_max[at], scratch));
            met += hits->at(i).found() ? 1 : 0;
        }
    }
    return met;
}

/// A merge of height fields, which go on for ever, of balls, and of boxes whose faces often lie in one place.
/// `clear`: some are.
void add_merge(csg::WorldData& data, Rng& rng, bool clear)
{
    csg::HeightField::Grid grid;
    grid.columns = grid.rows = 9;
    for (int i = 0; i < 81; ++i) grid.levels.push_back(static_cast<std::uint16_t>(rng.below(1u << 16)));
    grid.water = rng.below(2) == 0 ? 0.0 : 16000.0;
    const auto terrain = csg::make_freeform<csg::HeightField>(grid);
    csg::Tree tree{.op = csg::Tree::Op::Merge};
    for (int i = 0; i < 24; ++i) {
        const glm::dvec3 at = rng.point(5.0);
        const csg::Transform frame =
            csg::Transform::translate(at) *
            csg::Transform::rotate_degrees(rng.below(4) == 0 ? glm::dvec3(0.0) : rng.point(180.0)) *
            csg::Transform::scale(glm::dvec3(rng.uniform(2.0, 5.0), rng.uniform(0.5, 2.0), 4.0));
        const glm::dvec3 corner = glm::floor(at);
        const csg::Solid solid = i % 4 == 1   ? csg::Solid(csg::Sphere{at, rng.uniform(0.5, 2.0)})
                                 : i % 4 == 2 ? csg::Solid(csg::Box{corner, corner + 2.0})
                                              : csg::Solid(csg::Freeform{terrain, frame});
        data.surface_opaque.push_back(clear && rng.below(3) == 0 ? 0 : 1);
        tree.operands.push_back(
            csg::Tree::leaf(data.store.add(solid, static_cast<csg::SurfaceId>(data.surface_opaque.size() - 1))));
    }
    csg::Program program = csg::build(tree, data.store);
    REQUIRE(program.merged.size() == tree.operands.size());
    data.add_program(std::move(program), 0, 7);
    data.shadow_kinds = 4;
    data.finish();
}

}  // namespace

TEST_CASE("what holds a point is found by the hierarchy as by a loop over all items", "[trace][world]")
{
    int inside = 0, outside = 0;
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        csg::WorldData data;
        random_world::fill(data, rng, 1 + static_cast<int>(rng.below(150)));
        const csg::InsideIndex index(data);
        std::vector<std::uint32_t> holders;
        for (int i = 0; i < 9; ++i) {
            alignas(64) std::array<double, 64> x, y, z;
            const std::size_t count = i % 3 != 0 ? 64 : 1 + rng.below(64);
            const double apart = i % 2 != 0 ? 12.0 : 0.5;
            const glm::dvec3 middle = rng.point(12.0);
            for (std::size_t k = 0; k < 64; ++k) {
                const glm::dvec3 point = rng.below(8) == 0 ? rng.point(300.0) : middle + rng.point(apart);
                x[k] = point.x, y[k] = point.y, z[k] = point.z;
            }
            const std::uint64_t together = index.holds(x.data(), y.data(), z.data(), count);
            for (std::size_t k = 0; k < 64; ++k) {
                INFO("points " << i << ", point " << k);
                const glm::dvec3 point(x[k], y[k], z[k]);
                csg::World(data).containing(point, holders);
                REQUIRE(index.holds(point) == !holders.empty());
                REQUIRE((together >> k & 1) == (k < count && !holders.empty() ? 1 : 0));
                ++(holders.empty() ? outside : inside);
            }
        }
    }
    CHECK(inside > 1000);
    CHECK(outside > 1000);
}

TEST_CASE("the hierarchy finds what a loop over all items finds", "[trace][world]")
{
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        csg::WorldData data;
        random_world::fill(data, rng, 1 + static_cast<int>(rng.below(150)));
        const csg::World world(data);
        csg::Scratch scratch;
        std::vector<csg::Hit> crossings;
        for (int i = 0; i < 400; ++i) {
            INFO("ray " << i);
            const csg::Ray ray = random_ray(rng);
            check_same(world.nearest(ray, 1e-4, numbers::kInfinity, kImage, scratch),
                       by_force(data, ray, 1e-4, numbers::kInfinity, scratch));
            const double t_max = rng.uniform(0.5, 25.0);
            const csg::Shadow shadow = shadow_by_force(data, ray, 1e-3, t_max, scratch);
            REQUIRE(world.shadow(ray, 1e-3, t_max, scratch) == shadow);
            REQUIRE(world.shadow_crossings(ray, 1e-3, t_max, scratch, crossings) == shadow);
            if (shadow == csg::Shadow::Blocked) continue;
            REQUIRE(crossings.empty() == (shadow == csg::Shadow::Clear));
            REQUIRE(std::is_sorted(crossings.begin(), crossings.end(),
                                   [](const auto& a, const auto& b) { return a.t < b.t; }));
        }
    }
}

TEST_CASE("a tile gives the answers of its rays one by one, bit for bit", "[trace][tile]")
{
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        INFO("seed " << seed);
        Rng rng(1000 + seed);
        csg::WorldData data;
        random_world::fill(data, rng, 200);
        check_tiles(data, rng, 60);
    }
}

TEST_CASE("a tile meets a merge of many solids where its rays do one by one", "[trace][tile]")
{
    int met = 0;
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        INFO("seed " << seed);
        Rng rng(5000 + seed);
        csg::WorldData data;
        add_merge(data, rng, seed % 3 == 0);
        met += check_tiles(data, rng, 40);
    }
    CHECK(met > 5000);
}

TEST_CASE("a tile of shadow rays crosses what its rays cross one by one", "[trace][tile]")
{
    int filtered = 0, too_many = 0;
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        INFO("seed " << seed);
        Rng rng(2000 + seed);
        csg::WorldData data;
        random_world::fill(data, rng, 200, seed % 2 == 0 ? 1 : 2);
        const csg::World world(data);
        csg::Scratch scratch;
        std::vector<csg::Hit> expected;
        const auto found = std::make_unique<csg::CrossingTile>();
        for (int k = 0; k < 60; ++k) {
            const csg::RayTile tile = any_tile(rng, k);
            world.shadow_crossings(tile, scratch, *found);
            for (int i = 0; i < tile.count; ++i) {
                INFO("tile " << k << " ray " << i);
                const auto at = static_cast<std::size_t>(i);
                REQUIRE(found->ending[at] ==
                        world.shadow_crossings(tile.ray(i), tile.t_min[at], tile.t_max[at], scratch, expected));
                if (found->ending[at] != csg::Shadow::Filtered) continue;
                if (found->count[at] == csg::CrossingTile::kTooMany) {
                    REQUIRE(expected.size() > csg::CrossingTile::kMost);
                    ++too_many;
                    continue;
                }
                ++filtered;
                REQUIRE(found->count[at] == expected.size());
                for (std::size_t h = 0; h < expected.size(); ++h) check_same(found->hits[at][h], expected[h]);
            }
        }
    }
    CHECK(filtered > 5000);
    CHECK(too_many > 0);
}

TEST_CASE("of two surfaces in one place the first declared is seen", "[trace][world]")
{
    csg::WorldData data;
    for (csg::SurfaceId s = 0; s < 20; ++s) {
        data.surface_opaque.push_back(1);
        data.add_solid(data.store.add(csg::Box{{-1, -1, 0}, {1, 1, 1}}, s), false, s, 7);
    }
    data.finish();
    csg::Scratch scratch;
    CHECK(csg::World(data).nearest({{0.1, 0.2, -5}, {0, 0, 1}}, 1e-4, numbers::kInfinity, kImage, scratch).surface ==
          0);
}

TEST_CASE("a point is reported inside the objects that hold it", "[trace][world]")
{
    csg::WorldData data;
    data.surface_opaque = {1, 1, 1};
    data.add_solid(data.store.add(csg::Sphere{{0, 0, 0}, 2}, 0), false, 0, 7);
    data.add_solid(data.store.add(csg::Sphere{{9, 0, 0}, 2}, 1), false, 1, 7);
    data.add_solid(data.store.add(csg::Plane{{0, 1, 0}, 1}, 2), false, 2, 7);
    data.finish();
    std::vector<std::uint32_t> objects;
    csg::World(data).containing({0, 0, 0}, objects);
    CHECK(objects == std::vector<std::uint32_t>{0, 2});
}
