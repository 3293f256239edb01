#include "tests/csg/tree/walk_trees.h"

#include <catch2/catch.hpp>

using namespace csg;
using csg_test::Object;
using csg_test::Rng;

TEST_CASE("of two ends in one place a walk sees what the general evaluation sees", "[csg][boolean]")
{
    int asked = 0, found = 0, undecided = 0;
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
            Crossing nearest{.t = kInfinity};
            ++asked;
            const ProductAnswer answer =
                BooleanWalk(o.program, o.store, ray, t_min, kInfinity, scratch).nearest(nearest);
            const Crossing expected = Evaluation(o.program, o.store, ray, t_min, kInfinity, other).nearest();
            if (answer == ProductAnswer::Undecided) {
                ++undecided;
            } else {
                REQUIRE((answer == ProductAnswer::Found) == (expected.part != kNoPart));
                if (answer == ProductAnswer::Found) {
                    ++found;
                    REQUIRE(nearest.t == expected.t);
                    REQUIRE(nearest.part == expected.part);
                    REQUIRE(nearest.face == expected.face);
                    REQUIRE(nearest.inverted == expected.inverted);
                }
            }
            std::vector<Crossing> mine;
            if (!BooleanWalk(o.program, o.store, ray, t_min, kInfinity, scratch).crossings([&](const Crossing& c) {
                    mine.push_back(c);
                }))
                continue;
            const auto [begin, end] = visible_crossings(o.program, o.store, ray, t_min, kInfinity, other);
            REQUIRE(mine.size() == static_cast<std::size_t>(end - begin));
            for (std::size_t i = 0; i < mine.size(); ++i) REQUIRE(mine[i].t == begin[i].t);
        }
    }
    CHECK(asked > 20000);
    CHECK(found > 5000);
    CHECK(undecided < asked / 5);
}
