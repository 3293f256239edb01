#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <algorithm>

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
        made.solid = store.add(make(rng));
        return made;
    }
    made.op = static_cast<Tree::Op>(1 + rng.below(4));
    const int operands = 2 + rng.below(3);
    for (int i = 0; i < operands; ++i) made.operands.push_back(tree_of(rng, store, depth - 1, make));
    return made;
}

struct Tally {
    int usable = 0, found = 0, undecided = 0, asked = 0;
};

bool before(const Crossing& a, const Crossing& b)
{
    return a.t != b.t ? a.t < b.t : a.part != b.part ? a.part < b.part : a.face < b.face;
}

/// The sum of products's answers, where it has one, are those of the general evaluation.
void compare(const Object& o, Rng& rng, int rays, bool along_axis, Tally& tally)
{
    if (!o.program.products.usable()) return;
    ++tally.usable;
    Scratch scratch, other;
    for (int r = 0; r < rays; ++r) {
        Ray ray = csg_test::ray_near(rng, {0, 0, 0}, 1.2, 4.0);
        if (along_axis) ray = {{0.25 * rng.below(8) - 0.875, 0.25 * rng.below(8) - 0.875, -4.0}, {0.0, 0.0, 1.0}};
        const double t_min = r % 2 ? 1e-4 : rng.uniform(1.0, 6.0), t_max = r % 3 ? kInfinity : rng.uniform(2.0, 8.0);
        Crossing nearest{.t = kInfinity};
        ++tally.asked;
        const auto answer =
            ProductFront(o.program.products, o.store, ray, nullptr, t_min, t_max, scratch).nearest(nearest);
        const Crossing expected = Evaluation(o.program, o.store, ray, t_min, t_max, other).nearest();
        if (answer == ProductFront::Answer::Undecided) {
            ++tally.undecided;
        } else {
            REQUIRE((answer == ProductFront::Answer::Found) == (expected.part != kNoPart));
            if (answer == ProductFront::Answer::Found) {
                ++tally.found;
                REQUIRE(nearest.t == expected.t);
                REQUIRE(nearest.part == expected.part);
                REQUIRE(nearest.face == expected.face);
                REQUIRE(nearest.inverted == expected.inverted);
            }
        }
        std::vector<Crossing> mine, general;
        const auto all = ProductFront(o.program.products, o.store, ray, nullptr, t_min, t_max, scratch)
                             .crossings([&](const Crossing& c) {
                                 const auto same = [&](const Crossing& m) {
                                     return m.t == c.t && m.part == c.part && m.face == c.face;
                                 };
                                 if (std::none_of(mine.begin(), mine.end(), same)) mine.push_back(c);
                             });
        if (all == ProductFront::Answer::Undecided) continue;
        const auto [begin, end] = visible_crossings(o.program, o.store, ray, t_min, t_max, other);
        general.assign(begin, end);
        std::sort(mine.begin(), mine.end(), before);
        std::sort(general.begin(), general.end(), before);
        REQUIRE(mine.size() == general.size());
        for (std::size_t i = 0; i < mine.size(); ++i) {
            REQUIRE(mine[i].t == general[i].t);
            REQUIRE(mine[i].part == general[i].part);
        }
    }
}

/// 3000 random trees of solids that `make` gives, `rays` rays each.
template <class Make>
Tally compare_trees(Make&& make, int deepest, int rays, bool along_axis)
{
    Tally tally;
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        Object o;
        const Tree tree = tree_of(rng, o.store, 1 + rng.below(deepest), make);
        o.program = build(tree, o.store);
        compare(o, rng, rays, along_axis, tally);
    }
    return tally;
}

}  // namespace

TEST_CASE("the flat form answers as the general evaluation does", "[csg][products]")
{
    const Tally tally = compare_trees(any_solid, 3, 10, false);
    CHECK(tally.usable > 1200);
    CHECK(tally.found > 4000);
    CHECK(tally.undecided < tally.asked / 100);
}

TEST_CASE("where faces coincide the flat form gives up rather than guess", "[csg][products]")
{
    const Tally tally = compare_trees(lattice_solid, 2, 8, true);
    CHECK(tally.found > 2000);
    CHECK(tally.undecided > 300);
}

TEST_CASE("many cuts go through a hierarchy of their own", "[csg][products]")
{
    Rng rng(7);
    Object o;
    Tree tree{.op = Tree::Op::Difference};
    tree.operands.push_back(Tree::leaf(o.store.add(Box{{-1, -1, -1}, {1, 1, 1}})));
    for (int i = 0; i < 300; ++i)
        tree.operands.push_back(Tree::leaf(o.store.add(Sphere{rng.point(1.0), rng.uniform(0.03, 0.2)})));
    o.program = build(tree, o.store);
    REQUIRE(o.program.products.trees.size() == 1);
    Tally tally;
    compare(o, rng, 3000, false, tally);
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
    CHECK(build(cut, o.store).products.simple());
    Tree within{.op = Tree::Op::Intersection};
    within.operands = {merge, Tree::leaf(o.store.add(Box{{-1, -1, -1}, {1, 1, 1}}))};
    CHECK_FALSE(build(within, o.store).products.usable());
}
