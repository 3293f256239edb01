#include "tests/csg/tree/walk_trees.h"

#include <catch2/catch.hpp>

using namespace csg;
using csg_test::Object;
using csg_test::Rng;

TEST_CASE("ends in order and a mask tell what merged spans tell", "[csg][boolean]")
{
    int asked = 0, found = 0, undecided = 0;
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
            Crossing nearest{.t = kInfinity};
            ++asked;
            const ProductAnswer answer = BooleanWalk(o.program, o.store, ray, t_min, t_max, scratch).nearest(nearest);
            const Crossing expected = Evaluation(o.program, o.store, ray, t_min, t_max, other).nearest();
            if (answer == ProductAnswer::Undecided) {
                ++undecided;
                continue;
            }
            REQUIRE((answer == ProductAnswer::Found) == (expected.part != kNoPart));
            if (answer == ProductAnswer::Found) {
                ++found;
                REQUIRE(nearest.t == expected.t);
                REQUIRE(nearest.part == expected.part);
                REQUIRE(nearest.face == expected.face);
                REQUIRE(nearest.inverted == expected.inverted);
            }
            std::vector<Crossing> mine;
            if (!BooleanWalk(o.program, o.store, ray, t_min, t_max, scratch).crossings([&](const Crossing& c) {
                    mine.push_back(c);
                }))
                continue;
            const auto [begin, end] = visible_crossings(o.program, o.store, ray, t_min, t_max, other);
            REQUIRE(mine.size() == static_cast<std::size_t>(end - begin));
            for (std::size_t i = 0; i < mine.size(); ++i) REQUIRE(mine[i].t == begin[i].t);
        }
    }
    CHECK(asked > 25000);
    CHECK(found > 4000);
    CHECK(undecided < asked / 20);
}
