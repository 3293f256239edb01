#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace csg;
using csg_test::Object;
using csg_test::Rng;

namespace {

Solid solid_for_walk(Rng& rng)
{
    const glm::dvec3 c = rng.point(1.0);
    switch (rng.below(8)) {
    case 0: return Sphere{c, rng.uniform(0.3, 1.2)};
    case 1: return Box{c, c + rng.uniform(0.2, 1.5)};
    case 2: return OrientedBox{{-0.8, -0.6, -0.7}, {0.7, 0.5, 0.9}, csg_test::random_transform(rng)};
    case 3: return Plane{rng.direction(), rng.uniform(-0.5, 1.0)};
    case 4: return Cylinder::make(c, -c, rng.uniform(0.2, 0.8), rng.coin(), {});
    case 5: return Torus{0.8, rng.uniform(0.1, 0.4), csg_test::random_transform(rng)};
    case 6: return Disc{};
    default:
        return Quadric{{1, rng.uniform(-1, 1), 1}, {0.1, 0.2, 0}, {0, 0, 0}, -0.5, csg_test::random_transform(rng)};
    }
}

/// Operators of every kind, clips and inverses among them.
Tree tree_for_walk(Rng& rng, SolidStore& store, int depth)
{
    Tree made;
    if (depth == 0 || rng.below(4) == 0) {
        made.solid = store.add(solid_for_walk(rng));
    } else {
        made.op = static_cast<Tree::Op>(1 + rng.below(4));
        const int operands = 2 + rng.below(3);
        for (int i = 0; i < operands; ++i) made.operands.push_back(tree_for_walk(rng, store, depth - 1));
    }
    made.inverse = rng.below(6) == 0;
    if (rng.below(3) == 0) made.clips.push_back(tree_for_walk(rng, store, depth == 0 ? 0 : 1));
    return made;
}

}  // namespace

TEST_CASE("ends in order and a mask tell what merged spans tell", "[csg][boolean]")
{
    int asked = 0, found = 0, undecided = 0;
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        Object o;
        o.program = build(tree_for_walk(rng, o.store, 1 + rng.below(3)), o.store);
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
    CHECK(found > asked / 5);
    CHECK(undecided < asked / 20);
}
