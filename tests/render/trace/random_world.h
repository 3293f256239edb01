#pragma once

#include "csg/world/world.h"
#include "csg/items/world_data.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <random>

/// Random scenes and rays; the same seed gives the same ones.
namespace random_world {

class Rng {
public:
    explicit Rng(std::uint32_t seed) : engine_(seed) {}
    double uniform(double low, double high) { return low + (high - low) * (static_cast<double>(engine_()) * 0x1p-32); }
    glm::dvec3 point(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }
    glm::dvec3 direction()
    {
        for (;;) {
            const glm::dvec3 v = point(1.0);
            const double length = glm::length(v);
            if (length > 0.1 && length < 1.0) return v / length;
        }
    }
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(engine_()) % n; }

private:
    std::mt19937 engine_;
};

inline csg::Solid solid(Rng& rng, const glm::dvec3& center, double size)
{
    const glm::dvec3 half(rng.uniform(0.3, 1.0) * size, rng.uniform(0.3, 1.0) * size, rng.uniform(0.3, 1.0) * size);
    const csg::Transform frame = csg::Transform::translate(center) * csg::Transform::rotate_degrees(rng.point(180.0)) *
                                 csg::Transform::scale(half);
    switch (rng.below(9)) {
    case 0: return csg::Sphere{center, size};
    case 1: return csg::Box{center - half, center + half};
    case 2: return csg::Cylinder::make(center, center + 2.0 * size * rng.direction(), 0.5 * size, rng.below(4) == 0);
    case 3: return csg::Torus{size, 0.3 * size, csg::Transform::translate(center)};
    case 4: return csg::Ellipsoid{frame};
    case 5: return csg::OrientedBox{glm::dvec3(-1.0), glm::dvec3(1.0), frame};
    case 7:
        return csg::Quadric{
            {1, rng.uniform(-1, 1), 1}, {0.1, 0, 0}, {0, rng.uniform(-1, 1), 0}, rng.uniform(-1, 0.1), frame};
    case 6: return csg::Cone{rng.uniform(0.0, 0.8), frame, rng.below(4) == 0};
    default: {
        const glm::dvec3 a = center + size * rng.direction(), b = center + size * rng.direction();
        return csg::Triangle::make({center, a, b});
    }
    }
}

/// Convex operands whose faces often lie in one plane.
inline csg::Solid block(Rng& rng, const glm::dvec3& center, double size)
{
    const auto step = [&] { return 0.5 * size * static_cast<double>(1 + rng.below(2)); };
    if (rng.below(4) == 0) return csg::Plane{{0.0, 1.0, 0.0}, center.y + step()};
    if (rng.below(3) == 0)
        return csg::Cylinder::make(center - glm::dvec3(0, step(), 0), center + glm::dvec3(0, step(), 0), step(), false);
    return csg::Box{center - glm::dvec3(step(), step(), step()), center + glm::dvec3(step(), step(), step())};
}

/// A ball of faces with two surfaces in turn, some of them missing, others twice: large enough for levels of nodes.
inline csg::Mesh mesh(Rng& rng, const glm::dvec3& center, csg::SurfaceId first, csg::SurfaceId second)
{
    csg::MeshInput input;
    const auto rings = 4 + rng.below(20), sectors = 2 * rings;
    for (std::uint32_t i = 0; i <= rings; ++i)
        for (std::uint32_t k = 0; k <= sectors; ++k) {
            const double up = std::acos(-1.0) * i / rings, round = 2.0 * std::acos(-1.0) * k / sectors;
            const double far = 1.0 + 0.2 * std::sin(5.0 * up) * std::cos(3.0 * round);
            input.vertices.push_back(
                far * glm::dvec3(std::sin(up) * std::cos(round), std::cos(up), std::sin(up) * std::sin(round)));
        }
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const auto times = rng.below(12);  // none, or two in one place
        for (std::uint32_t k = 0; k < (times == 0 ? 0u : times == 1 ? 2u : 1u); ++k)
            input.faces.push_back({.vertex = {a, b, c}, .slot = static_cast<std::uint32_t>(input.faces.size() % 2)});
    };
    for (std::uint32_t i = 0; i < rings; ++i)
        for (std::uint32_t k = 0; k < sectors; ++k) {
            const std::uint32_t a = i * (sectors + 1) + k, b = a + sectors + 1;
            add(a, a + 1, b);
            add(a + 1, b + 1, b);
        }
    csg::Mesh made;
    made.shape = std::make_shared<const csg::MeshShape>(input);
    made.surfaces = {first, second};
    if (rng.below(3) != 0)
        made.frame = csg::Transform::translate(center) * csg::Transform::rotate_degrees(rng.point(180.0)) *
                     csg::Transform::scale(glm::dvec3(rng.uniform(0.3, 2.0), rng.uniform(0.3, 2.0), 1.0));
    return made;
}

/// Lone solids, some CSG objects, meshes and two planes; one surface in `clear_one_in` is clear, some items are hidden
/// from shadow rays.
inline void fill(csg::WorldData& world, Rng& rng, int count, std::uint32_t clear_one_in = 5)
{
    std::uint32_t object = 0;
    const auto next_surface = [&] {
        world.surface_opaque.push_back(rng.below(clear_one_in) == 0 ? 0 : 1);
        return static_cast<csg::SurfaceId>(world.surface_opaque.size() - 1);
    };
    const auto visible = [&] { return static_cast<std::uint8_t>(rng.below(6) == 0 ? 3 : 7); };
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 center = rng.point(10.0);
        if (rng.below(3) != 0) {
            world.add_solid(world.store.add(solid(rng, center, rng.uniform(0.2, 1.2)), next_surface()), false, object++,
                            visible());
            continue;
        }
        csg::Tree tree;
        constexpr csg::Tree::Op kOps[] = {csg::Tree::Op::Difference, csg::Tree::Op::Intersection, csg::Tree::Op::Merge};
        tree.op = kOps[rng.below(3)];
        const bool blocks = rng.below(3) == 0;
        for (std::uint32_t k = 0; k < 2 + rng.below(3); ++k) {
            const csg::Solid operand = blocks ? block(rng, center, 1.0)
                                              : solid(rng, center + rng.point(0.5), rng.uniform(0.5, 1.2));
            tree.operands.push_back(csg::Tree::leaf(world.store.add(operand, next_surface())));
        }
        csg::Program program = csg::build(tree, world.store);
        if (!program.nodes.empty()) world.add_program(std::move(program), object++, visible());
    }
    for (std::uint32_t k = 0; k < 1 + rng.below(3); ++k) {
        const csg::SurfaceId first = next_surface(), second = rng.below(2) == 0 ? first : next_surface();
        world.add_solid(world.store.add(mesh(rng, rng.point(8.0), first, second), first), false, object++, visible());
    }
    // One with enough cuts for a hierarchy of them.
    csg::Tree pitted{.op = csg::Tree::Op::Difference};
    const glm::dvec3 middle = rng.point(6.0);
    pitted.operands.push_back(csg::Tree::leaf(world.store.add(csg::Box{middle - 2.0, middle + 2.0}, next_surface())));
    for (int i = 0; i < 60; ++i)
        pitted.operands.push_back(csg::Tree::leaf(
            world.store.add(csg::Sphere{middle + rng.point(2.2), rng.uniform(0.1, 0.6)}, next_surface())));
    world.add_program(csg::build(pitted, world.store), object++, visible());
    world.add_solid(world.store.add(csg::Plane{{0, 1, 0}, -9.0}, next_surface()), false, object++, 7);
    world.add_solid(world.store.add(csg::Plane{{0, 0, -1}, -12.0}, next_surface()), false, object++, 7);
    world.shadow_kinds = 4;
    world.finish();
}

}  // namespace random_world
