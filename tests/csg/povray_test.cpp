#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <map>
#include <sstream>
#include <string>

using namespace csg;
using csg_test::Object;


namespace {

const Transform kTurn = Transform::rotate_degrees({30, 40, 50});

Tree node(Tree::Op op, std::vector<Tree> operands)
{
    Tree tree{.op = op};
    tree.operands = std::move(operands);
    return tree;
}

/// The objects of data/make_povray_traces.py.
std::map<std::string, Tree> objects(SolidStore& store)
{
    const auto leaf = [&](const Solid& solid) { return Tree::leaf(store.add(solid)); };
    const auto tube = [&](const glm::dvec3& a, const glm::dvec3& b, double r, bool open = false) {
        return leaf(Cylinder::make(a, b, r, open, {}));
    };
    const auto cone = [&](const glm::dvec3& a, double ra, const glm::dvec3& b, double rb) {
        Cone made;
        double unused = 0.0;
        REQUIRE(Cone::make(a, ra, b, rb, false, {}, made, unused));
        return leaf(made);
    };
    const Transform moved = Transform::translate({0.1, -0.2, 0.3}) * kTurn * Transform::scale({1, 0.7, 1.3});
    Tree clipped = leaf(Sphere{{0, 0, 0}, 1});
    clipped.clips = {leaf(Plane{{0, 0, 1}, 0.1}), leaf(Box{{-2, -0.5, -2}, {2, 0.9, 2}})};
    Tree inverse_union = node(Tree::Op::Union, {leaf(Sphere{{0, 0, 0}, 1}), leaf(Sphere{{0.7, 0, 0}, 0.8})});
    inverse_union.inverse = true;
    return {
        {"sphere", leaf(Sphere{{0.2, 0.1, -0.3}, 0.9})},
        {"ellipsoid", leaf(Ellipsoid{kTurn * Transform::scale({1, 0.5, 1.5})})},
        {"box", leaf(Box{{-1, -0.5, -0.7}, {1, 0.5, 0.8}})},
        {"oriented_box", leaf(OrientedBox{{-1, -0.5, -0.7}, {1, 0.5, 0.8}, kTurn})},
        {"cylinder", tube({-0.5, -1, 0.2}, {0.5, 1, 0}, 0.6)},
        {"open_cylinder", tube({0, -1, 0}, {0, 1, 0}, 0.7, true)},
        {"cone", cone({0, -1, 0}, 1, {0.2, 1, 0}, 0.3)},
        {"double_cone", cone({0, 0, 0}, 1, {0, 2, 0}, -0.5)},
        {"torus", leaf(Torus{1, 0.25, {}})},
        {"moved_torus", leaf(Torus{1, 0.4, moved})},
        {"spindle", leaf(Torus{0.5, 0.8, {}})},
        {"quadric", leaf(Quadric{{1, 2, 4}, {0.3, -0.2, 0.1}, {-0.5, 0.2, 0}, -1, {}})},
        {"hyperboloid", leaf(Quadric{{1, 1, -1}, {0, 0, 0}, {0, 0, 0}, -0.1, {}})},
        {"disc", leaf(Disc::make({0.1, 0, 0}, {1, 1, 0}, 1, 0.3, {}))},
        {"difference",
         node(Tree::Op::Difference, {leaf(Box{{-1, -1, -1}, {1, 1, 1}}), leaf(Sphere{{0.5, 0.5, -1}, 0.9}),
                                     tube({-2, 0, 0}, {2, 0, 0}, 0.4), leaf(Plane{{0, 1, 0}, -0.6})})},
        {"intersection",
         node(Tree::Op::Intersection,
              {leaf(Sphere{{0, 0, 0}, 1}), leaf(Box{{-0.8, -0.7, -0.6}, {0.9, 0.8, 0.7}}), leaf(Torus{0.6, 0.5, {}})})},
        {"merge", node(Tree::Op::Merge, {leaf(Sphere{{-0.3, 0, 0}, 0.8}), leaf(Box{{0, -0.5, -0.5}, {1.2, 0.5, 0.5}}),
                                         cone({0, -1, 0}, 0.7, {0, 1, 0}, 0.1)})},
        {"nested", node(Tree::Op::Difference,
                        {node(Tree::Op::Merge, {leaf(Sphere{{0, 0, 0}, 1}), leaf(Torus{0.9, 0.4, {}})}),
                         node(Tree::Op::Union, {tube({0, -2, 0}, {0, 2, 0}, 0.4),
                                                node(Tree::Op::Intersection, {leaf(Box{{0, -1, -2}, {2, 0.2, 2}}),
                                                                              leaf(Sphere{{0.5, 0, 0}, 0.9})})})})},
        {"clipped", clipped},
        {"inverse_union", inverse_union},
    };
}

}  // namespace

TEST_CASE("first hit and normal are POV-Ray's", "[csg][povray]")
{
    Object o;
    const std::map<std::string, Tree> trees = objects(o.store);
    std::map<std::string, Program> programs;
    for (const auto& [name, tree] : trees) programs[name] = build(tree, o.store);
    std::ifstream file(CSG_TEST_DATA "/povray_traces.csv");
    std::string line;
    REQUIRE(std::getline(file, line));
    int rows = 0, hits = 0;
    while (std::getline(file, line)) {
        INFO(line);
        ++rows;
        std::istringstream in(line);
        std::string name, cell;
        std::getline(in, name, ',');
        double v[12];
        for (double& value : v) {
            std::getline(in, cell, ',');
            value = std::stod(cell);
        }
        const Ray ray{{v[0], v[1], v[2]}, glm::normalize(glm::dvec3(v[3], v[4], v[5]))};
        const glm::dvec3 point(v[6], v[7], v[8]), normal(v[9], v[10], v[11]);
        const Crossing hit = nearest_visible(programs.at(name), o.store, ray, 1e-4, kInfinity, o.scratch);
        const bool expected = glm::length(normal) > 0.5;
        REQUIRE((hit.part != kNoPart) == expected);
        if (!expected) continue;
        ++hits;
        REQUIRE(glm::distance(ray.at(hit.t), point) < 1e-8);
        REQUIRE(glm::distance(normal_at(o.store, hit.part, hit.face, hit.inverted, ray.at(hit.t)), normal) < 1e-7);
    }
    REQUIRE(rows == 800);
    REQUIRE(hits > 500);
}
