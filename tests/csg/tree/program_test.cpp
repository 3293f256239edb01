#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace csg;
using csg_test::Object;
using csg_test::Rng;

namespace {

Solid random_solid(Rng& rng, bool convex_only)
{
    const glm::dvec3 c = rng.point(1.0);
    const double r = rng.uniform(0.4, 1.2);
    Cone cone;
    double unused = 0.0;
    switch (rng.below(convex_only ? 7 : 10)) {
    case 0: return Sphere{c, r};
    case 1: return Ellipsoid{csg_test::random_transform(rng)};
    case 2: return Box{c - r, c + rng.uniform(0.1, 0.9)};
    case 3: return OrientedBox{{-0.8, -0.6, -0.7}, {0.7, 0.5, 0.9}, csg_test::random_transform(rng)};
    case 4: return Plane{rng.direction(), rng.uniform(-0.5, 1.0)};
    case 5: return Cylinder::make(c, -c, r, false, {});
    case 6: Cone::make(c, r, -c, 0.3 * r, false, {}, cone, unused); return cone;
    case 7: return Torus{r, 0.4 * r, csg_test::random_transform(rng)};
    case 8: return Quadric{{1, rng.uniform(-1, 1), 1}, {0.1, 0.2, 0}, {0, 0, 0}, -0.5, csg_test::random_transform(rng)};
    default: return Torus{0.4 * r, r, csg_test::random_transform(rng)};
    }
}

Tree random_tree(Rng& rng, SolidStore& store, int depth)
{
    Tree made;
    if (depth == 0 || rng.below(5) == 0) {
        made.solid = store.add(random_solid(rng, false));
    } else {
        made.op = static_cast<Tree::Op>(1 + rng.below(4));
        const int operands = 1 + rng.below(3);
        for (int i = 0; i < operands; ++i) made.operands.push_back(random_tree(rng, store, depth - 1));
    }
    made.inverse = rng.below(5) == 0;
    if (rng.below(8) == 0) made.clips.push_back(Tree::leaf(store.add(random_solid(rng, false))));
    return made;
}

/// Membership straight from the tree by POV-Ray's rules: the oracle for programs.
bool member(const Tree& tree, bool inverted, const SolidStore& store, const glm::dvec3& p)
{
    for (const Tree& clip : tree.clips)
        if (!member(clip, false, store, p)) return false;
    inverted = inverted != tree.inverse;
    if (tree.op == Tree::Op::Leaf)
        return with_solid(store, tree.solid,
                          [&](const auto& s) { return inverted ? s.contains_inverted(p) : s.contains(p); });
    const bool unites = (tree.op == Tree::Op::Union || tree.op == Tree::Op::Merge) != inverted;
    for (std::size_t i = 0; i < tree.operands.size(); ++i) {
        const bool subtracted = tree.op == Tree::Op::Difference && i > 0;
        if (member(tree.operands[i], inverted != subtracted, store, p) == unites) return unites;
    }
    return !unites;
}

bool near_any(const SpanList& spans, double t, double distance)
{
    for (const Span& s : spans)
        if (std::abs(s.in.t - t) < distance || std::abs(s.out.t - t) < distance) return true;
    return false;
}

}  // namespace

TEST_CASE("random trees hold exactly the points their operands say", "[csg][program]")
{
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        Object o;
        const Tree tree = random_tree(rng, o.store, 1 + rng.below(5));
        o.program = build(tree, o.store);
        for (int r = 0; r < 6; ++r) {
            const Ray ray = csg_test::ray_near(rng, {0, 0, 0}, 1.5, 4.0);
            const SpanList spans = inside_spans(o.program, o.store, ray, o.scratch);
            for (std::uint32_t i = 1; i < spans.size(); ++i) REQUIRE(spans[i - 1].out.t <= spans[i].in.t);
            for (int k = 0; k < 12; ++k) {
                const double t = rng.uniform(0.0, 8.0);
                if (near_any(spans, t, 1e-6)) continue;
                REQUIRE(spans.contains(t) == member(tree, false, o.store, ray.at(t)));
                REQUIRE(contains(o.program, o.store, ray.at(t)) == member(tree, false, o.store, ray.at(t)));
            }
        }
    }
}

TEST_CASE("without unions and clips what is seen is where the inside changes", "[csg][program]")
{
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        Object o;
        Tree tree{.op = static_cast<Tree::Op>(2 + rng.below(3))};
        for (int i = 0; i < 2 + rng.below(4); ++i) {
            Solid solid = random_solid(rng, true);
            tree.operands.push_back(Tree::leaf(o.store.add(solid)));
        }
        o.program = build(tree, o.store);
        const Ray ray = csg_test::ray_near(rng, {0, 0, 0}, 1.2, 4.0);
        std::vector<Crossing> ends;
        for (const Span& s : inside_spans(o.program, o.store, ray, o.scratch))
            for (const Crossing& c : {s.in, s.out})
                if (c.drawn()) ends.push_back(c);
        const auto [begin, end] = visible_crossings(o.program, o.store, ray, -kInfinity, kInfinity, o.scratch);
        REQUIRE(static_cast<std::size_t>(end - begin) == ends.size());
        for (std::size_t i = 0; i < ends.size(); ++i) {
            REQUIRE(begin[i].t == ends[i].t);
            REQUIRE(begin[i].part == ends[i].part);
            REQUIRE(begin[i].inverted == ends[i].inverted);
        }
    }
}

TEST_CASE("the nearest is the first of all, from anywhere on the ray", "[csg][program]")
{
    int found = 0;
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        Object o;
        Tree tree;
        if (rng.coin()) {  // one term of convex solids
            tree.op = rng.coin() ? Tree::Op::Difference : Tree::Op::Intersection;
            for (int i = 0; i < 2 + rng.below(6); ++i)
                tree.operands.push_back(Tree::leaf(o.store.add(random_solid(rng, true))));
        } else {
            tree = random_tree(rng, o.store, 1 + rng.below(4));
        }
        o.program = build(tree, o.store);
        for (int r = 0; r < 8; ++r) {
            const Ray ray = csg_test::ray_near(rng, {0, 0, 0}, 1.2, 4.0);
            const double t_min = r % 2 ? 1e-4 : rng.uniform(1.0, 6.0),
                         t_max = r % 3 ? kInfinity : rng.uniform(1.0, 8.0);
            const auto [begin, end] = visible_crossings(o.program, o.store, ray, t_min, t_max, o.scratch);
            const bool any = begin != end;
            const Crossing first = any ? *begin : Crossing{};
            const Crossing nearest = nearest_visible(o.program, o.store, ray, t_min, t_max, o.scratch);
            REQUIRE((nearest.part != kNoPart) == any);
            if (!any) continue;
            ++found;
            REQUIRE(nearest.t == first.t);
            REQUIRE(nearest.part == first.part);
            REQUIRE(nearest.face == first.face);
            REQUIRE(nearest.inverted == first.inverted);
        }
    }
    REQUIRE(found > 3000);
}

TEST_CASE("the order of operands does not matter", "[csg][program]")
{
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        Object o;
        Tree tree{.op = static_cast<Tree::Op>(1 + rng.below(4))};
        for (int i = 0; i < 4; ++i) tree.operands.push_back(random_tree(rng, o.store, 1));
        Tree other = tree;
        std::reverse(other.operands.begin() + (tree.op == Tree::Op::Difference ? 1 : 0), other.operands.end());
        const Program a = build(tree, o.store), b = build(other, o.store);
        const Ray ray = csg_test::ray_near(rng, {0, 0, 0}, 1.2, 4.0);
        std::vector<double> ts;
        const auto [begin, end] = visible_crossings(a, o.store, ray, 0.0, kInfinity, o.scratch);
        for (const Crossing* c = begin; c != end; ++c) ts.push_back(c->t);
        const auto [first, last] = visible_crossings(b, o.store, ray, 0.0, kInfinity, o.scratch);
        REQUIRE(static_cast<std::size_t>(last - first) == ts.size());
        for (std::size_t i = 0; i < ts.size(); ++i) REQUIRE(first[i].t == ts[i]);
    }
}

TEST_CASE("De Morgan: the inverse of a merge is the intersection of the inverses", "[csg][program]")
{
    for (std::uint32_t seed = 0; seed < std::uint32_t(csg_test::share(1000)); ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        Object o;
        Tree merge{.op = Tree::Op::Merge, .inverse = true}, both{.op = Tree::Op::Intersection};
        for (int i = 0; i < 3; ++i) {
            Tree operand = random_tree(rng, o.store, 2);
            merge.operands.push_back(operand);
            operand.inverse = !operand.inverse;
            both.operands.push_back(operand);
        }
        const Program a = build(merge, o.store), b = build(both, o.store);
        const Ray ray = csg_test::ray_near(rng, {0, 0, 0}, 1.2, 4.0);
        std::vector<double> ts;
        for (const Span& s : inside_spans(a, o.store, ray, o.scratch)) ts.insert(ts.end(), {s.in.t, s.out.t});
        std::size_t i = 0;
        for (const Span& s : inside_spans(b, o.store, ray, o.scratch)) {
            REQUIRE(i + 2 <= ts.size());
            REQUIRE(s.in.t == ts[i]);
            REQUIRE(s.out.t == ts[i + 1]);
            i += 2;
        }
        REQUIRE(i == ts.size());
    }
}

TEST_CASE("bounds hold everything that is seen", "[csg][program]")
{
    for (std::uint32_t seed = 0; seed < std::uint32_t(csg_test::share(1000)); ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        Object o;
        o.program = build(random_tree(rng, o.store, 3), o.store);
        const Ray ray = csg_test::ray_near(rng, {0, 0, 0}, 1.5, 4.0);
        const auto [begin, end] = visible_crossings(o.program, o.store, ray, -kInfinity, kInfinity, o.scratch);
        for (const Crossing* c = begin; c != end; ++c) {
            const glm::dvec3 p = ray.at(c->t);
            for (int i = 0; i < 3; ++i) {
                REQUIRE(p[i] >= o.program.bounds.lower[i] - 1e-9 * (1 + std::abs(c->t)));
                REQUIRE(p[i] <= o.program.bounds.upper[i] + 1e-9 * (1 + std::abs(c->t)));
            }
        }
    }
}

TEST_CASE("a union shows buried surfaces, a merge does not", "[csg][program]")
{
    Object o;
    Tree tree{.op = Tree::Op::Union};
    tree.operands = {Tree::leaf(o.store.add(Sphere{{0, 0, 0}, 1})), Tree::leaf(o.store.add(Sphere{{0, 0, 1}, 1}))};
    const Ray ray{{0, 0, -5}, {0, 0, 1}};
    const auto count = [&](const Tree& t) {
        const Program program = build(t, o.store);
        const auto [begin, end] = visible_crossings(program, o.store, ray, 0, kInfinity, o.scratch);
        return end - begin;
    };
    CHECK(count(tree) == 4);
    tree.op = Tree::Op::Merge;
    CHECK(count(tree) == 2);
    tree.op = Tree::Op::Union;
    tree.inverse = true;
    CHECK(count(tree) == 2);  // spec 5a, 8.1
}

TEST_CASE("subtrahends that cannot reach the minuend are dropped", "[csg][program]")
{
    Object o;
    Tree tree{.op = Tree::Op::Difference};
    tree.operands = {Tree::leaf(o.store.add(Box{{-1, -1, -1}, {1, 1, 1}})),
                     Tree::leaf(o.store.add(Sphere{{5, 0, 0}, 1})), Tree::leaf(o.store.add(Sphere{{1, 0, 0}, 0.5}))};
    const Program program = build(tree, o.store);
    CHECK(program.nodes.size() == 3);
    CHECK(program.products.simple());
}

TEST_CASE("an intersection of solids that are apart is nothing", "[csg][program]")
{
    Object o;
    Tree tree{.op = Tree::Op::Intersection};
    tree.operands = {Tree::leaf(o.store.add(Box{{-1, -1, -1}, {1, 1, 1}})),
                     Tree::leaf(o.store.add(Sphere{{5, 0, 0}, 1}))};
    const Program program = build(tree, o.store);
    CHECK(program.bounds.empty());
    CHECK(nearest_visible(program, o.store, {{0, 0, -5}, {0, 0, 1}}, 0, kInfinity, o.scratch).part == kNoPart);
    CHECK_FALSE(contains(program, o.store, {0, 0, 0}));
}

TEST_CASE("patches bound nothing", "[csg][program]")
{
    Object o;
    const Tree patch = Tree::leaf(o.store.add(Triangle::make({glm::dvec3(-2, -2, 0), {2, -2, 0}, {0, 3, 0}})));
    const Tree sphere = Tree::leaf(o.store.add(Sphere{{0, 0, 0}, 1}));
    const Ray ray{{0.1, 0.1, -5}, {0, 0, 1}};
    const auto count = [&](Tree::Op op, const Tree& a, const Tree& b) {
        Tree tree{.op = op};
        tree.operands = {a, b};
        const Program program = build(tree, o.store);
        const auto [begin, end] = visible_crossings(program, o.store, ray, 0, kInfinity, o.scratch);
        return end - begin;
    };
    CHECK(count(Tree::Op::Union, sphere, patch) == 3);
    CHECK(count(Tree::Op::Merge, sphere, patch) == 2);         // buried in the sphere
    CHECK(count(Tree::Op::Intersection, sphere, patch) == 1);  // only the patch, where it is inside the sphere
    CHECK(count(Tree::Op::Difference, sphere, patch) == 1);
}

TEST_CASE("planes that enclose a polyhedron give it a box", "[csg][program]")
{
    Object o;
    Tree tree{.op = Tree::Op::Intersection};  // |x| + |y| + |z| <= 1, moved
    for (int k = 0; k < 8; ++k) {
        const glm::dvec3 n = glm::dvec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1) / std::sqrt(3.0);
        const Plane side{n, 1.0 / std::sqrt(3.0)};
        tree.operands.push_back(Tree::leaf(o.store.add(side.transformed(Transform::translate({10, 20, 30})))));
    }
    const Program program = build(tree, o.store);
    for (int i = 0; i < 3; ++i) {
        CHECK(program.bounds.lower[i] == Approx(10.0 * (i + 1) - 1.0).margin(1e-5));
        CHECK(program.bounds.upper[i] == Approx(10.0 * (i + 1) + 1.0).margin(1e-5));
    }
    tree.operands.resize(4);  // open toward +z
    CHECK_FALSE(build(tree, o.store).bounds.finite());
}
