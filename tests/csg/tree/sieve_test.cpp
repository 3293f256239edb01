#include "tests/csg/tree/walk_trees.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace csg;
using csg_test::Object;
using csg_test::Rng;

namespace {

/// An operator of many small operands, some of which are differences, perhaps inside of another.
Tree wide_tree(Rng& rng, SolidStore& store)
{
    Tree wide;
    wide.op = static_cast<Tree::Op>(1 + rng.below(4));
    if (wide.op == Tree::Op::Difference || wide.op == Tree::Op::Intersection)
        wide.operands.push_back(Tree::leaf(store.add(Box{glm::dvec3(-1.2), glm::dvec3(1.2)}, 0)));
    const int count = 8 + rng.below(30);
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 c = rng.point(1.2);
        const double radius = rng.uniform(0.1, 0.5);
        Tree one = Tree::leaf(store.add(Sphere{c, radius}, 0));
        if (rng.coin()) {
            const Tree hole = Tree::leaf(store.add(Cylinder::make(c - 1.0, c + 1.0, 0.5 * radius, false, {}), 0));
            one = {.op = Tree::Op::Difference, .operands = {one, hole}};
        }
        one.inverse = wide.op == Tree::Op::Intersection || rng.below(20) == 0;
        wide.operands.push_back(one);
    }
    if (rng.coin()) wide.clips.push_back(Tree::leaf(store.add(Plane{rng.direction(), 0.3}, 0)));
    if (rng.coin()) return wide;
    const Tree other = Tree::leaf(store.add(Sphere{rng.point(0.5), 1.0}, 0));
    return {.op = static_cast<Tree::Op>(1 + rng.below(4)), .operands = {other, wide}};
}

}  // namespace

TEST_CASE("boxes of many operands by eights leave nothing out", "[csg][sieve]")
{
    int sieved = 0, crossed = 0;
    for (std::uint32_t seed = 0; seed < 600; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        Object o;
        o.program = build(wide_tree(rng, o.store), o.store);
        if (o.program.sieves.empty()) continue;
        ++sieved;
        Program plain = o.program;
        for (Node& node : plain.nodes) node.first_sieve = node.last_sieve = 0;
        plain.sieves.clear();
        Scratch scratch, other;
        for (int r = 0; r < 30; ++r) {
            INFO("ray " << r);
            const Ray ray = csg_test::ray_near(rng, {0, 0, 0}, 1.5, 4.0);
            const double t_min = r % 2 != 0 ? 1e-4 : rng.uniform(1.0, 5.0),
                         t_max = r % 3 != 0 ? kInfinity : t_min + rng.uniform(0.5, 4.0);
            const auto [a, a_end] = Evaluation(o.program, o.store, ray, t_min, t_max, scratch).crossings();
            const auto [b, b_end] = Evaluation(plain, o.store, ray, t_min, t_max, other).crossings();
            REQUIRE(a_end - a == b_end - b);
            for (std::ptrdiff_t i = 0; i < a_end - a; ++i) {
                ++crossed;
                REQUIRE(a[i].t == b[i].t);
                REQUIRE(a[i].part == b[i].part);
                REQUIRE(a[i].inverted == b[i].inverted);
            }
            const Crossing nearest = Evaluation(o.program, o.store, ray, t_min, t_max, scratch).nearest(),
                           expected = Evaluation(plain, o.store, ray, t_min, t_max, other).nearest();
            REQUIRE(nearest.t == expected.t);
            REQUIRE(nearest.part == expected.part);
            const SpanList inside = Evaluation(o.program, o.store, ray, t_min, t_max, scratch).inside(),
                           whole = Evaluation(plain, o.store, ray, t_min, t_max, other).inside();
            for (int i = 0; i < 20; ++i) {  // spans are right within the range only
                const double t = rng.uniform(t_min, std::min(t_max, 10.0));
                REQUIRE(inside.contains(t) == whole.contains(t));
            }
        }
    }
    CHECK(sieved > 300);
    CHECK(crossed > 10000);
}
