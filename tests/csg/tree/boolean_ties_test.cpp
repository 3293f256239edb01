#include "tests/csg/tree/walk_trees.h"

#include <catch2/catch.hpp>

using namespace csg;
using csg_test::Object;
using csg_test::Rng;

namespace {

/// Solids whose faces often lie in the same places as others': corners on a lattice, tubes around one axis.
Solid solid_on_lattice(Rng& rng)
{
    const glm::dvec3 corner(rng.below(3) - 1, rng.below(3) - 1, rng.below(3) - 1);
    const double radius = 0.5 * (1 + rng.below(3));
    switch (rng.below(5)) {
    case 0: return Box{corner, corner + glm::dvec3(1 + rng.below(2), 1 + rng.below(2), 1 + rng.below(2))};
    case 1: return Plane{glm::dvec3(0, rng.coin() ? 1 : -1, 0), static_cast<double>(rng.below(3) - 1)};
    case 2: return Sphere{{0, 0, 0}, radius};
    default: {
        const double end = 1 + rng.below(2);
        return Cylinder::make({-end, 0, 0}, {end, 0, 0}, radius, rng.below(3) == 0, {});
    }
    }
}

Tree tree_on_lattice(Rng& rng, SolidStore& store, int depth)
{
    Tree made;
    if (depth == 0 || rng.below(4) == 0) {
        made.solid = store.add(solid_on_lattice(rng), 0);
    } else {
        made.op = static_cast<Tree::Op>(1 + rng.below(4));
        const int operands = 2 + rng.below(2);
        for (int i = 0; i < operands; ++i) made.operands.push_back(tree_on_lattice(rng, store, depth - 1));
    }
    made.inverse = rng.below(8) == 0;
    if (rng.below(3) == 0) made.clips.push_back(tree_on_lattice(rng, store, 0));
    return made;
}

}  // namespace

TEST_CASE("of two ends in one place a walk sees what the general evaluation sees", "[csg][boolean]")
{
    int asked = 0, found = 0, undecided = 0;
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        Object o;
        o.program = build(tree_on_lattice(rng, o.store, 1 + rng.below(3)), o.store);
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
