#include "bench/numerics/csg_checks.h"

#include "bench/numerics/oracle.h"
#include "csg/tree/front.h"
#include "tests/csg/support.h"

#include <algorithm>
#include <numeric>

namespace numerics {
namespace {

using csg::Ray;
using csg::Transform;
using csg::Tree;
using csg_test::Object;
using csg_test::Rng;

Tree node(Tree::Op op, std::vector<Tree> operands)
{
    Tree tree{.op = op};
    tree.operands = std::move(operands);
    return tree;
}

std::vector<double> seen(Object& object, const Ray& ray)
{
    const auto [first, last] = csg::visible_crossings(object.program, object.store, ray, -numbers::kInfinity,
                                                      numbers::kInfinity, object.scratch);
    std::vector<double> all;
    for (const csg::Crossing* c = first; c != last; ++c) all.push_back(c->t);
    return all;
}

/// A sphere without a slightly smaller one: four crossings in their order, or two where the ray meets the shell alone.
CsgRow shell(double thickness, double distance, long rays)
{
    CsgRow row{.name = distance > 100 ? "shell_far" : "shell", .value = thickness};
    Object object;
    const csg::Sphere outer{{0, 0, 0}, 1.0}, inner{{0, 0, 0}, 1.0 - thickness};
    object.program = csg::build(
        node(Tree::Op::Difference, {Tree::leaf(object.store.add(outer)), Tree::leaf(object.store.add(inner))}),
        object.store);
    Rng rng(7);
    for (; row.rays < rays; ++row.rays) {
        const Ray ray = csg_test::ray_near(rng, glm::dvec3(0.0), 0.5, distance);
        const std::vector<double> all = seen(object, ray);
        std::vector<Quad> truth;
        for (const csg::Sphere& sphere : {outer, inner})
            for (const Quad t : crossings(parts_of(sphere, along(ray, distance)), -3, 3)) truth.push_back(t);
        row.wrong += all.size() != truth.size() || !std::is_sorted(all.begin(), all.end()) ? 1 : 0;
    }
    return row;
}

/// A box cut by one whose face lies `gap` beyond its own (negative: short of it, which leaves a skin).
CsgRow face(double gap, long rays)
{
    CsgRow row{.name = "face_gap", .value = gap};
    Object object;
    const csg::Box body{{-1, -1, -1}, {1, 1, 1}}, cut{{-0.5, -0.5, -2}, {0.5, 0.5, 1.0 + gap}};
    object.program =
        csg::build(node(Tree::Op::Difference, {Tree::leaf(object.store.add(body)), Tree::leaf(object.store.add(cut))}),
                   object.store);
    Rng rng(11);
    for (; row.rays < rays; ++row.rays) {
        const glm::dvec3 aim(rng.uniform(-0.45, 0.45), rng.uniform(-0.45, 0.45), 1.0),
            from = aim + glm::dvec3(rng.uniform(-0.2, 0.2), rng.uniform(-0.2, 0.2), 3.0);
        const std::vector<double> all = seen(object, {from, glm::normalize(aim - from)});
        const bool skin =
            std::any_of(all.begin(), all.end(), [&](double t) { return std::abs(t - glm::length(aim - from)) < 1e-6; });
        row.wrong += skin != (gap <= 0.0) ? 1 : 0;  // coincident: POV-Ray draws the face (spec 5a, 8.4)
    }
    return row;
}

/// From inside, every ray leaves: also at an edge or a vertex.
CsgRow corners(bool planes, long rays)
{
    CsgRow row{.name = planes ? "corners_planes" : "corners_box"};
    Object object;
    Rng rng(13);
    const Transform turn = Transform::rotate_degrees({31, 17, 53});
    Tree tree;
    if (planes) {
        std::vector<Tree> sides;
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {-1.0, 1.0}) {
                glm::dvec3 n(0.0);
                n[axis] = sign;
                sides.push_back(Tree::leaf(object.store.add(csg::Plane{turn.vector(n), 1.0})));
            }
        tree = node(Tree::Op::Intersection, std::move(sides));
    } else {
        tree = Tree::leaf(object.store.add(csg::OrientedBox{{-1, -1, -1}, {1, 1, 1}, turn}));
    }
    object.program = csg::build(tree, object.store);
    for (; row.rays < rays; ++row.rays) {
        glm::dvec3 corner(rng.coin() ? 1.0 : -1.0, rng.coin() ? 1.0 : -1.0, rng.coin() ? 1.0 : -1.0);
        if (rng.coin()) corner[rng.below(3)] = rng.uniform(-1.0, 1.0);
        const glm::dvec3 from = turn.point(rng.point(0.9)), to = turn.point(corner);
        const csg::Crossing met = csg::nearest_visible(object.program, object.store, {from, glm::normalize(to - from)},
                                                       0.0, numbers::kInfinity, object.scratch);
        row.wrong += met.part == csg::kNoPart || std::abs(met.t - glm::length(to - from)) > 1e-12 ? 1 : 0;
    }
    return row;
}

/// The same bits whatever the order of the operands.
CsgRow order(Tree::Op op, long rays)
{
    CsgRow row{.name = op == Tree::Op::Union   ? "order_union"
                       : op == Tree::Op::Merge ? "order_merge"
                                               : "order_intersection"};
    constexpr long kRaysOfOne = 50;
    for (std::uint32_t seed = 0; row.rays < rays; ++seed) {
        Rng rng(seed);
        const double size = op == Tree::Op::Intersection ? 1.2 : 0.6;
        std::vector<csg::Solid> solids;
        for (int i = 0; i < 6; ++i) {
            const Transform t = Transform::translate(rng.point(0.5)) * Transform::rotate_degrees(rng.point(180)) *
                                Transform::scale(glm::dvec3(size));
            switch (i) {
            case 0: solids.push_back(csg::Sphere{t.offset, size}); break;
            case 1: solids.push_back(csg::OrientedBox{{-1, -1, -1}, {1, 1, 1}, t}); break;
            case 2: solids.push_back(csg::Cylinder::make({0, -1, 0}, {0, 1, 0}, 0.8, false, t)); break;
            case 3: solids.push_back(csg::Torus{1.0, 0.6, t}); break;
            case 4: solids.push_back(csg::Ellipsoid{t * Transform::scale({1, 0.7, 1.3})}); break;
            default: solids.push_back(csg::Quadric{{1, 0.5, 1}, {0, 0, 0}, {0, 0.2, 0}, -0.9, t}); break;
            }
        }
        Object first, second;
        for (Object* object : {&first, &second}) {
            std::vector<Tree> operands;
            for (const csg::Solid& solid : solids) operands.push_back(Tree::leaf(object->store.add(solid)));
            if (object == &second)
                for (std::size_t i = operands.size(); i > 1; --i)
                    std::swap(operands[i - 1], operands[static_cast<std::size_t>(rng.below(static_cast<int>(i)))]);
            object->program = csg::build(node(op, std::move(operands)), object->store);
        }
        for (long i = 0; i < kRaysOfOne; ++i, ++row.rays) {
            const Ray ray = csg_test::ray_near(rng, glm::dvec3(0.0), 1.0, 5.0);
            std::vector<double> a = seen(first, ray), b = seen(second, ray);
            std::sort(a.begin(), a.end());
            std::sort(b.begin(), b.end());
            row.wrong += a != b ? 1 : 0;
        }
    }
    return row;
}

}  // namespace

std::vector<CsgRow> csg_checks(long rays)
{
    std::vector<CsgRow> rows;
    for (const double thickness : {1e-1, 1e-3, 1e-5, 1e-7, 1e-9}) {
        rows.push_back(shell(thickness, 3.0, rays));
        rows.push_back(shell(thickness, 1e4, rays));
    }
    for (const double gap : {-1e-3, -1e-6, -1e-9, -1e-12, 0.0, 1e-12, 1e-9, 1e-6, 1e-3})
        rows.push_back(face(gap, rays));
    rows.push_back(corners(false, rays));
    rows.push_back(corners(true, rays));
    for (const Tree::Op op : {Tree::Op::Union, Tree::Op::Merge, Tree::Op::Intersection})
        rows.push_back(order(op, rays));
    return rows;
}

}  // namespace numerics
