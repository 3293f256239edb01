#include "tests/csg/tree/merged_spans.h"
#include "tests/csg/tree/walk_trees.h"

#include <catch2/catch.hpp>

using namespace csg;
using csg_test::MergedSpans;
using csg_test::Object;
using csg_test::Rng;

namespace {

/// What evaluation has told of the rays so far.
struct Told {
    int asked = 0, found = 0;
};

void check_same(const Crossing& mine, const Crossing& expected)
{
    REQUIRE(mine.t == expected.t);
    REQUIRE(mine.part == expected.part);
    REQUIRE(mine.face == expected.face);
    REQUIRE(mine.inverted == expected.inverted);
}

/// Evaluation along the ray against merged spans: the nearest end, all of them, and what is inside.
void check_ray(const Object& o, const Ray& ray, double t_min, double t_max, Scratch& scratch, Told& told)
{
    MergedSpans law(o.program, o.store, ray);
    ++told.asked;
    const Crossing nearest = Evaluation(o.program, o.store, ray, t_min, t_max, scratch).nearest(),
                   expected = law.nearest(t_min, t_max);
    REQUIRE((nearest.part == kNoPart) == (expected.part == kNoPart));
    if (nearest.part != kNoPart) {
        ++told.found;
        check_same(nearest, expected);
    }
    std::vector<Crossing> all = law.crossings(t_min, t_max);
    std::stable_sort(all.begin(), all.end(), [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
    const auto [begin, end] = Evaluation(o.program, o.store, ray, t_min, t_max, scratch).crossings();
    REQUIRE(all.size() == static_cast<std::size_t>(end - begin));
    for (std::size_t i = 0; i < all.size(); ++i) check_same(begin[i], all[i]);
    const std::vector<Span> whole = law.inside();
    const SpanList inside = inside_spans(o.program, o.store, ray, scratch);
    REQUIRE(inside.size() == whole.size());
    for (std::uint32_t i = 0; i < inside.size(); ++i) {
        REQUIRE(inside[i].in.t == whole[i].in.t);
        REQUIRE(inside[i].out.t == whole[i].out.t);
    }
}

/// Random rays against random trees, seed by seed.
template <class MakeTree>
Told check_trees(int seeds, int rays, MakeTree&& make)
{
    Told told;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(csg_test::share(seeds)); ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        Object o;
        o.program = build(make(rng, o.store), o.store);
        if (o.program.nodes.empty()) continue;
        for (int r = 0; r < rays; ++r) {
            const Ray ray = csg_test::ray_near(rng, {0, 0, 0}, 1.2, 4.0);
            const double t_min = r % 2 != 0 ? 1e-4 : rng.uniform(1.0, 6.0),
                         t_max = r % 3 != 0 ? kInfinity : rng.uniform(2.0, 8.0);
            INFO("ray " << r);
            check_ray(o, ray, t_min, t_max, o.scratch, told);
        }
    }
    return told;
}

/// Many small operands under one operator, as rays meet few of; some of them are trees.
Tree wide_tree(Rng& rng, SolidStore& store, int depth)
{
    Tree made{.op = static_cast<Tree::Op>(1 + rng.below(4))};
    if (made.op == Tree::Op::Difference || made.op == Tree::Op::Intersection)
        made.operands.push_back(Tree::leaf(store.add(Box{glm::dvec3(-1.2), glm::dvec3(1.2)}, 0)));
    const int count = 4 + rng.below(20);
    for (int i = 0; i < count; ++i) {
        Tree one = depth > 0 && rng.below(4) == 0
                       ? wide_tree(rng, store, depth - 1)
                       : Tree::leaf(store.add(Sphere{rng.point(1.2), rng.uniform(0.1, 0.5)}, 0));
        one.inverse = made.op == Tree::Op::Intersection || rng.below(20) == 0;
        made.operands.push_back(one);
    }
    if (rng.below(4) == 0) made.clips.push_back(Tree::leaf(store.add(Plane{rng.direction(), 0.3}, 0)));
    if (rng.below(4) == 0) made.bounds.push_back(Tree::leaf(store.add(Sphere{rng.point(0.5), 1.0}, 0)));
    return made;
}

/// Operators in one another, deep rather than wide, without boxes: half-spaces and balls.
Tree deep_tree(Rng& rng, SolidStore& store, int depth)
{
    if (depth == 0) {
        Tree leaf = Tree::leaf(rng.coin() ? store.add(Plane{rng.direction(), rng.uniform(-0.8, 0.8)}, 0)
                                          : store.add(Sphere{rng.point(1.0), rng.uniform(0.4, 1.2)}, 0));
        leaf.inverse = rng.coin();
        return leaf;
    }
    Tree made{.op = static_cast<Tree::Op>(1 + rng.below(4))};
    const int operands = 2 + rng.below(2);
    for (int i = 0; i < operands; ++i) made.operands.push_back(deep_tree(rng, store, depth - 1));
    return made;
}

}  // namespace

TEST_CASE("evaluation tells what merged spans tell", "[csg][evaluation]")
{
    const Told told = check_trees(
        3000, 10, [](Rng& rng, SolidStore& store) { return csg_test::tree_for_walk(rng, store, 1 + rng.below(3)); });
    CHECK(told.asked > csg_test::share(25000));
    CHECK(told.found > csg_test::share(4000));
}

TEST_CASE("of ends in one place evaluation sees what merged spans see", "[csg][evaluation]")
{
    const Told told = check_trees(
        12000, 8, [](Rng& rng, SolidStore& store) { return csg_test::tree_on_lattice(rng, store, 1 + rng.below(3)); });
    CHECK(told.asked > csg_test::share(50000));
    CHECK(told.found > csg_test::share(10000));
}

TEST_CASE("evaluation leaves nothing out of wide and deep trees", "[csg][evaluation]")
{
    // These trees are a hundred times as large as the others: of them a share of the share.
    const Told wide =
        check_trees(csg_test::share(600), 12, [](Rng& rng, SolidStore& store) { return wide_tree(rng, store, 2); });
    CHECK(wide.found > csg_test::share(csg_test::share(1000)));
    const Told deep =
        check_trees(csg_test::share(400), 12, [](Rng& rng, SolidStore& store) { return deep_tree(rng, store, 5); });
    CHECK(deep.found > csg_test::share(csg_test::share(1000)));
}
