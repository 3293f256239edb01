#include "csg/tree/held.h"

#include "csg/world/world.h"
#include "csg/items/world_data.h"
#include "csg/tree/program.h"

#include <catch2/catch.hpp>

using namespace csg;

namespace {

constexpr std::uint8_t kEveryKind = 0xff;

/// A sphere of radius 1 about the origin, seen only by rays that meet the half-space y <= -0.2.
struct GuardedSphere {
    WorldData data;
    Scratch scratch;

    GuardedSphere()
    {
        data.add_solid(data.store.add(Sphere{glm::dvec3(0.0), 1.0}, 0), false, 0, kEveryKind);
        data.programs.push_back(build(Tree::leaf(data.store.add(Plane{{0, 1, 0}, -0.2})), data.store));
        data.guard_last({Aabb::everything(), {0}, false, false});
        data.surface_opaque = {1};
        data.finish();
    }
};

}  // namespace

TEST_CASE("what a bound holds", "[csg][guard]")
{
    SolidStore store;
    const auto program = [&](const Solid& solid) { return build(Tree::leaf(store.add(solid)), store); };
    const Program sphere = program(Sphere{glm::dvec3(0.0), 1.0}), box = program(Box{glm::dvec3(-1.0), glm::dvec3(1.0)});
    // A sphere in a sphere though its box sticks out; a box whose corners alone do.
    CHECK(held_by(sphere, program(Sphere{glm::dvec3(0.0), 1.005}), store));
    CHECK(held_by(sphere, program(Sphere{glm::dvec3(0.0), 0.995}), store));  // meant to hold it
    CHECK_FALSE(held_by(sphere, program(Sphere{glm::dvec3(0.0), 0.97}), store));
    CHECK_FALSE(held_by(sphere, program(Sphere{{0.1, 0.0, 0.0}, 1.03}), store));
    CHECK_FALSE(held_by(box, program(Sphere{glm::dvec3(0.0), 1.5}), store));
    CHECK(held_by(box, program(Sphere{glm::dvec3(0.0), 1.75}), store));
    CHECK_FALSE(held_by(program(Plane{{0, 1, 0}, 0.0}), program(Box{glm::dvec3(-1e6), glm::dvec3(1e6)}), store));
}

TEST_CASE("a bound hides from camera rays what they do not meet it for, however far off it is", "[csg][guard]")
{
    GuardedSphere scene;
    const World world(scene.data);
    const auto seen = [&](const glm::dvec3& from, const glm::dvec3& direction) {
        return world.nearest({from, glm::normalize(direction)}, 1e-4, kInfinity, kEveryKind, scene.scratch).found();
    };
    CHECK(seen({0, 0, -5}, {0, -0.01, 1}));  // meets the half-space far behind the sphere
    CHECK_FALSE(seen({0, 0, -5}, {0, 0.01, 1}));
    CHECK(seen({0, -0.5, -5}, {0, 0.01, 1}));  // starts inside
}

TEST_CASE("a bound hides the same from a shadow ray whichever end it starts at", "[csg][guard]")
{
    GuardedSphere scene;
    const World world(scene.data);
    const auto blocked = [&](const glm::dvec3& a, const glm::dvec3& b) {
        return world.shadow({a, glm::normalize(b - a)}, 1e-3, glm::distance(a, b) - 1e-3, scene.scratch) ==
               Shadow::Blocked;
    };
    const glm::dvec3 light(0, 5, 0), below(0.2, -3, 0);
    CHECK_FALSE(blocked(light, {0.2, -0.1, 0}));
    CHECK_FALSE(blocked({0.2, -0.1, 0}, light));
    CHECK(blocked(light, below));
    CHECK(blocked(below, light));
}
