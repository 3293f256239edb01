#include "tests/csg/tree/walk_trees.h"

#include <catch2/catch.hpp>

using namespace csg;
using csg_test::Object;
using csg_test::Rng;

namespace {

/// What walks have told of the rays so far.
struct Told {
    int asked = 0, found = 0, undecided = 0;
};

/// A walk along the ray against the general evaluation: the nearest end, then all of them.
void check_walk(const Object& o, const Ray& ray, double t_min, double t_max, Scratch& scratch, Scratch& other,
                Told& told)
{
    Crossing nearest{.t = kInfinity};
    ++told.asked;
    const ProductAnswer answer = BooleanWalk(o.program, o.store, ray, t_min, t_max, scratch).nearest(nearest);
    const Crossing expected = Evaluation(o.program, o.store, ray, t_min, t_max, other).nearest();
    if (answer == ProductAnswer::Undecided) {
        ++told.undecided;
    } else {
        REQUIRE((answer == ProductAnswer::Found) == (expected.part != kNoPart));
        if (answer == ProductAnswer::Found) {
            ++told.found;
            REQUIRE(nearest.t == expected.t);
            REQUIRE(nearest.part == expected.part);
            REQUIRE(nearest.face == expected.face);
            REQUIRE(nearest.inverted == expected.inverted);
        }
    }
    std::vector<Crossing> mine;
    if (!BooleanWalk(o.program, o.store, ray, t_min, t_max, scratch).crossings([&](const Crossing& c) {
            mine.push_back(c);
        }))
        return;
    const auto [begin, end] = visible_crossings(o.program, o.store, ray, t_min, t_max, other);
    REQUIRE(mine.size() == static_cast<std::size_t>(end - begin));
    for (std::size_t i = 0; i < mine.size(); ++i) REQUIRE(mine[i].t == begin[i].t);
}

}  // namespace

TEST_CASE("ends in order and a mask tell what merged spans tell", "[csg][boolean]")
{
    Told told;
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        Object o;
        o.program = build(csg_test::tree_for_walk(rng, o.store, 1 + rng.below(3)), o.store);
        if (!o.program.boolean.usable()) continue;
        Scratch scratch, other;
        for (int r = 0; r < 10; ++r) {
            const Ray ray = csg_test::ray_near(rng, {0, 0, 0}, 1.2, 4.0);
            const double t_min = r % 2 != 0 ? 1e-4 : rng.uniform(1.0, 6.0),
                         t_max = r % 3 != 0 ? kInfinity : rng.uniform(2.0, 8.0);
            INFO("ray " << r);
            check_walk(o, ray, t_min, t_max, scratch, other, told);
        }
    }
    CHECK(told.asked > 25000);
    CHECK(told.found > 4000);
    CHECK(told.undecided < told.asked / 20);
}

TEST_CASE("of two ends in one place a walk sees what the general evaluation sees", "[csg][boolean]")
{
    Told told;
    for (std::uint32_t seed = 0; seed < 12000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        Object o;
        o.program = build(csg_test::tree_on_lattice(rng, o.store, 1 + rng.below(3)), o.store);
        if (!o.program.boolean.usable() || o.program.boolean.leaves.size() < 2) continue;
        Scratch scratch, other;
        for (int r = 0; r < 12; ++r) {
            const Ray ray = csg_test::ray_near(rng, {0, 0, 0}, 1.2, 4.0);
            const double t_min = r % 2 != 0 ? 1e-4 : rng.uniform(1.0, 6.0);
            INFO("ray " << r);
            check_walk(o, ray, t_min, kInfinity, scratch, other, told);
        }
    }
    CHECK(told.asked > 20000);
    CHECK(told.found > 5000);
    CHECK(told.undecided < told.asked / 5);
}
