#include "tests/csg/support.h"

#include <catch2/catch.hpp>

using namespace csg;
using csg_test::Object;
using csg_test::Rng;

namespace {

/// 16384 rays from <0, 0, -4> over a field of view that holds the unit cube; returns the sum of ask(ray).
template <class Ask>
std::size_t over_camera_rays(const Ask& ask)
{
    std::size_t sum = 0;
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x)
            sum += ask(Ray{{0, 0, -4}, glm::normalize(glm::dvec3((x - 63.5) / 128, (y - 63.5) / 128, 1))});
    return sum;
}

}  // namespace

TEST_CASE("spans of a 64-sphere union, camera rays", "[!benchmark][csg]")
{
    Object o;
    Rng rng(1);
    Tree tree{.op = Tree::Op::Union};
    for (int i = 0; i < 64; ++i)
        tree.operands.push_back(Tree::leaf(o.store.add(Sphere{rng.point(1.0), rng.uniform(0.1, 0.4)})));
    o.program = build(tree, o.store);
    const auto spans = [&](const Ray& ray) { return inside_spans(o.program, o.store, ray, o.scratch).size(); };
    const auto hit = [&](const Ray& ray) {
        return nearest_visible(o.program, o.store, ray, 0, 100, o.scratch).part == kNoPart ? 0u : 1u;
    };
    REQUIRE(over_camera_rays(spans) > over_camera_rays(hit));
    BENCHMARK("16384 rays, inside spans") { return over_camera_rays(spans); };
    BENCHMARK("16384 rays, nearest") { return over_camera_rays(hit); };
}

TEST_CASE("one solid or one small tree, camera rays", "[!benchmark][csg]")
{
    Object o;
    Cone cone;
    double unused = 0.0;
    Cone::make({0, -1, 0}, 1.0, {0, 1, 0}, 0.3, false, {}, cone, unused);
    const Tree box = Tree::leaf(o.store.add(Box{{-1, -1, -1}, {1, 1, 1}}));
    const Tree sphere = Tree::leaf(o.store.add(Sphere{{0, 0, 0}, 1.2}));
    const Tree tube = Tree::leaf(o.store.add(Cylinder::make({-2, 0, 0}, {2, 0, 0}, 0.5, false, {})));
    const Tree torus = Tree::leaf(o.store.add(Torus{1.0, 0.4, Transform::rotate_degrees({70, 0, 0})}));
    const Tree quadric = Tree::leaf(o.store.add(Quadric{{1, 1, 1}, {0, 0, 0}, {0, 0, 0}, -1.0, {}}));
    const auto measure = [&](const char* name, const Tree& tree) {
        const Program program = build(tree, o.store);
        const auto hit = [&](const Ray& ray) {
            return nearest_visible(program, o.store, ray, 0, 100, o.scratch).part == kNoPart ? 0u : 1u;
        };
        REQUIRE(over_camera_rays(hit) > 1000);
        BENCHMARK(name) { return over_camera_rays(hit); };
    };
    Tree flat{.op = Tree::Op::Difference}, general{.op = Tree::Op::Difference};
    flat.operands = {box, sphere, tube};
    general.operands = {box, torus, tube};
    measure("sphere", sphere);
    measure("box", box);
    measure("cylinder", tube);
    measure("cone", Tree::leaf(o.store.add(cone)));
    measure("torus", torus);
    measure("quadric", quadric);
    measure("box - sphere - cylinder (flat form)", flat);
    measure("box - torus - cylinder (spans)", general);
}
