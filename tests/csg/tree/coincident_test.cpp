#include "tests/csg/support.h"

#include <catch2/catch.hpp>

using namespace csg;
using csg_test::Object;

namespace {

Tree pair(Tree::Op op, PartId a, PartId b)
{
    Tree tree{.op = op};
    tree.operands = {Tree::leaf(a), Tree::leaf(b)};
    return tree;
}

/// What is seen on the face z = c that both solids share, over rays of every direction: 'a' or 'b' when it is always
/// the part of that solid, '-' when it is always nothing there, '?' when it changes from ray to ray.
char seen(Object& o, Tree::Op op, PartId a, PartId b, double c)
{
    const Program program = build(pair(op, a, b), o.store);
    char answer = 0;
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        csg_test::Rng rng(seed);
        const glm::dvec3 target(rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3), c);
        const glm::dvec3 origin = target + glm::dvec3(rng.uniform(-2, 2), rng.uniform(-2, 2), -3.0);
        const Ray ray{origin, glm::normalize(target - origin)};
        const Crossing hit = nearest_visible(program, o.store, ray, 1e-4, kInfinity, o.scratch);
        char here = '-';
        if (hit.part != kNoPart && std::abs(ray.at(hit.t).z - c) < 1e-6) here = hit.part == a ? 'a' : 'b';
        if (answer == 0) answer = here;
        if (answer != here) return '?';
    }
    return answer;
}

}  // namespace

// The systematic outcomes of spec 5a, 8.4, also at offsets where POV-Ray itself speckles.
TEST_CASE("faces shared by two solids", "[csg][coincident]")
{
    for (const double c : {0.0, 0.1, 10.1, 1000.1}) {
        INFO("c " << c);
        Object o;
        const PartId box1 = o.store.add(Box{{-1, -1, c}, {1, 1, c + 2}});
        const PartId box2 = o.store.add(Box{{-0.8, -0.8, c}, {0.8, 0.8, c + 1}});
        const PartId tube1 = o.store.add(Cylinder::make({0, 0, c}, {0, 0, c + 2}, 1.0, false, {}));
        const PartId tube2 = o.store.add(Cylinder::make({0, 0, c}, {0, 0, c + 1}, 0.8, false, {}));
        const PartId floor = o.store.add(Plane{{0, 0, -1}, -c});
        const PartId turned = o.store.add(OrientedBox{
            {-1, -1, 0}, {1, 1, 2}, Transform::translate({0, 0, c}) * Transform::rotate_degrees({0, 0, 30})});
        using Op = Tree::Op;
        CHECK(seen(o, Op::Difference, box1, box2, c) == 'b');
        CHECK(seen(o, Op::Difference, tube1, tube2, c) == 'a');
        CHECK(seen(o, Op::Intersection, box1, box2, c) == 'b');
        CHECK(seen(o, Op::Intersection, box2, box1, c) == 'b');
        CHECK(seen(o, Op::Intersection, tube1, tube2, c) == '-');
        CHECK(seen(o, Op::Merge, box1, box2, c) == '-');
        CHECK((seen(o, Op::Merge, tube1, tube2, c) == 'a' || seen(o, Op::Merge, tube1, tube2, c) == 'b'));
        CHECK(seen(o, Op::Intersection, box1, floor, c) != '-');
        CHECK(seen(o, Op::Difference, turned, box2, c) != '-');
    }
}

TEST_CASE("boxes that share a face are asked about its points as rounded", "[csg][coincident]")
{
    using Op = Tree::Op;
    int beyond = 0, upon = 0;
    for (const double c : {0.25, 0.3, 0.7, -0.9, 10.1}) {
        Object o;
        const Box low{{-1, -1, c}, {1, 1, c + 2}}, inner{{-0.8, -0.8, c}, {0.8, 0.8, c + 1}};
        const PartId a = o.store.add(low), b = o.store.add(inner);
        const auto program = [&](Op op) { return build(pair(op, a, b), o.store); };
        const Program merge = program(Op::Merge), both = program(Op::Intersection), less = program(Op::Difference);
        for (std::uint32_t seed = 0; seed < 500; ++seed) {
            INFO("c " << c << ", seed " << seed);
            csg_test::Rng rng(seed);
            const glm::dvec3 target(rng.uniform(-0.7, 0.7), rng.uniform(-0.7, 0.7), c);
            const glm::dvec3 origin = target + glm::dvec3(rng.uniform(-9, 9), rng.uniform(-9, 9), rng.uniform(-9, -3));
            const Ray ray{origin, glm::normalize(target - origin)};
            const double t = (c - ray.origin.z) / ray.direction.z;
            const glm::dvec3 p = ray.at(t);
            REQUIRE(inner.contains(p) == low.contains(p));  // far from their other faces
            const auto on_face = [&](const Program& of) {
                const Crossing hit = nearest_visible(of, o.store, ray, 1e-4, kInfinity, o.scratch);
                return hit.part != kNoPart && hit.t == t ? hit.part : kNoPart;
            };
            const bool held = inner.contains(p);
            REQUIRE(on_face(merge) == (held ? kNoPart : b));
            REQUIRE(on_face(both) == (held ? b : kNoPart));
            REQUIRE(on_face(less) == (held ? b : a));
            ++(held ? upon : beyond);
        }
    }
    CHECK(beyond > 500);
    CHECK(upon > 500);
}

TEST_CASE("which of several identical boxes is seen", "[csg][coincident]")
{
    Object o;
    std::vector<Tree> boxes;
    for (int i = 0; i < 3; ++i) boxes.push_back(Tree::leaf(o.store.add(Box{{-1, -1, -1}, {1, 1, 1}})));
    const Tree big = Tree::leaf(o.store.add(Box{{-9, -9, -9}, {9, 9, 9}}));
    const auto winner = [&](const Tree& tree) {
        const Program program = build(tree, o.store);
        return nearest_visible(program, o.store, {{0.1, 0.2, -5}, {0, 0, 1}}, 0, kInfinity, o.scratch).part;
    };
    const auto node = [](Tree::Op op, std::vector<Tree> operands) {
        Tree tree{.op = op};
        tree.operands = std::move(operands);
        return tree;
    };
    using Op = Tree::Op;
    const PartId a = boxes[0].solid, b = boxes[1].solid, c = boxes[2].solid;
    CHECK(winner(node(Op::Union, boxes)) == c);
    CHECK(winner(node(Op::Intersection, boxes)) == c);
    CHECK(winner(node(Op::Merge, {boxes[0], boxes[1]})) == kNoPart);
    CHECK(winner(node(Op::Union, {node(Op::Intersection, {boxes[0], big}), boxes[1]})) == b);
    CHECK(winner(node(Op::Intersection, {node(Op::Union, {boxes[0], boxes[1]}), big})) == a);
    CHECK(winner(node(Op::Intersection, {node(Op::Intersection, {boxes[0], boxes[1]}), big})) == a);
}

TEST_CASE("abutting boxes merge without a wall between them", "[csg][coincident]")
{
    Object o;
    const PartId left = o.store.add(Box{{-1, -1, -1}, {0.1, 1, 1}}), right = o.store.add(Box{{0.1, -1, -1}, {1, 1, 1}});
    const Program program = build(pair(Tree::Op::Merge, left, right), o.store);
    for (std::uint32_t seed = 0; seed < 500; ++seed) {
        csg_test::Rng rng(seed);
        const Ray ray = csg_test::ray_near(rng, {0.1, 0, 0}, 0.5, 4.0);
        const auto [begin, end] = visible_crossings(program, o.store, ray, 0, kInfinity, o.scratch);
        REQUIRE(end - begin == 2);
    }
}

TEST_CASE("two half-spaces that share a plane make a sheet", "[csg][coincident]")
{
    Object o;
    const Tree tree = pair(Tree::Op::Intersection, o.store.add(Plane{{0, 0, 1}, 0}), o.store.add(Plane{{0, 0, -1}, 0}));
    const Program program = build(tree, o.store);
    CHECK(nearest_visible(program, o.store, {{0.3, 0.2, -5}, {0, 0, 1}}, 0, kInfinity, o.scratch).t == 5.0);
}

TEST_CASE("an open cylinder bounds but draws no ends", "[csg][coincident]")
{
    Object o;
    const PartId box = o.store.add(Box{{-2, -2, 0}, {2, 2, 1}});
    const PartId open = o.store.add(Cylinder::make({0, 0, -1}, {0, 0, 0.5}, 1.0, true, {}));
    const Program program = build(pair(Tree::Op::Difference, box, open), o.store);
    const Crossing hit = nearest_visible(program, o.store, {{0.1, 0.2, -5}, {0, 0, 1}}, 0, kInfinity, o.scratch);
    CHECK(hit.part == box);
    CHECK(hit.t == 6.0);  // through the hole without a bottom: the back of the box
}

TEST_CASE("a clip keeps surfaces inside and adds none", "[csg][coincident]")
{
    Object o;
    Tree sphere = Tree::leaf(o.store.add(Sphere{{0, 0, 0}, 1}));
    sphere.clips.push_back(Tree::leaf(o.store.add(Plane{{0, 0, -1}, 0})));  // keeps z >= 0
    for (const bool inverse : {false, true}) {
        sphere.inverse = inverse;
        const Program program = build(sphere, o.store);
        const Crossing hit = nearest_visible(program, o.store, {{0, 0, -5}, {0, 0, 1}}, 0, kInfinity, o.scratch);
        CHECK(hit.t == 6.0);
        CHECK(hit.inverted == inverse);
    }
}

TEST_CASE("a disc cuts a half-space but caps only its ring", "[csg][coincident]")
{
    Object o;
    const PartId box = o.store.add(Box{{-2, -2, 0}, {2, 2, 2}});
    const PartId disc = o.store.add(Disc::make({0, 0, 1}, {0, 0, 1}, 0.5, 0.0, {}));
    const Program program = build(pair(Tree::Op::Difference, box, disc), o.store);
    CHECK(nearest_visible(program, o.store, {{0.1, 0, -5}, {0, 0, 1}}, 0, kInfinity, o.scratch).part == disc);
    CHECK(nearest_visible(program, o.store, {{1, 0, -5}, {0, 0, 1}}, 0, kInfinity, o.scratch).t == 7.0);
}
