#include "csg/items/spawn_epsilon.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

using namespace csg;

namespace {

constexpr double kUsual = 1e-4;

}  // namespace

TEST_CASE("a ray within a box sees the box's other faces however near an edge it starts", "[csg][spawn_epsilon]")
{
    const Box box{{-1, -1, -1}, {1, 1, 1}};
    for (double beside = 1e-10; beside < 2e-4; beside *= 3.0) {
        // From the top down and out through the side, which it reaches after beside * sqrt(2).
        const Ray ray{{1.0 - beside, 1.0, 0.2}, glm::normalize(glm::dvec3(1, -1, 0))};
        const double there = beside * std::sqrt(2.0),
                     start = spawn_epsilon(box, ray, 3.0, std::sqrt(0.5), true, kUsual);
        INFO("beside " << beside);
        if (there < kUsual) {
            CHECK(start < there);
            CHECK(start > 0.0);
        } else {
            CHECK(start == kUsual);
        }
    }
}

TEST_CASE("a flat solid has a far side", "[csg][spawn_epsilon]")
{
    for (const double thickness : {1e-5, 1e-7, 1e-9, 1e-11}) {
        INFO("thickness " << thickness);
        const Ray down{{0.3, thickness, 0.4}, glm::normalize(glm::dvec3(0.1, -1, 0.2))};
        const double there = -thickness / down.direction.y;
        const Box box{{-1, 0, -1}, {1, thickness, 1}};
        CHECK(spawn_epsilon(box, down, 1.0, -down.direction.y, true, kUsual) < there);
        const Cylinder disc = Cylinder::make({0, 0, 0}, {0, thickness, 0}, 1.0, false, {});
        CHECK(spawn_epsilon(disc, down, 1.0, -down.direction.y, true, kUsual) < there);
    }
}

TEST_CASE("a ray never takes its own start for another crossing", "[csg][spawn_epsilon]")
{
    // Spheres of all sizes whose surface passes near the origin: the point has small coordinates, the sphere large
    // ones.
    csg_test::Rng rng(7);
    int told = 0, grazing = 0;
    for (int i = 0; i < csg_test::share(200000); ++i) {
        const double radius = std::pow(10.0, rng.uniform(-3, 6)), cosine = std::pow(10.0, rng.uniform(-6, 0));
        const glm::dvec3 at = rng.point(2.0), up = rng.direction(),
                         along = glm::normalize(glm::cross(up, rng.direction()));
        const Sphere sphere{at - radius * up, radius};
        const glm::dvec3 d = std::sqrt(1.0 - cosine * cosine) * along - cosine * up,
                         from = at - rng.uniform(0.1, 20.0) * d;
        Interval in;
        if (!sphere.interval({from, d}, in) || !(in.entry > 0.0)) continue;
        const Ray camera{from, d};
        const glm::dvec3 p = camera.at(in.entry), n = sphere.normal(p, 0);
        const double facing = glm::dot(d, n);
        // Mirrored it leaves for good; passing through it meets the far side after the chord.
        const Ray mirrored{p, glm::normalize(d - 2.0 * facing * n)};
        told += spawn_epsilon(sphere, mirrored, in.entry, facing, false, kUsual) != kUsual ? 1 : 0;
        const double chord = -2.0 * radius * facing;
        grazing += std::abs(facing) < 1e-3 ? 1 : 0;
        const double start = spawn_epsilon(sphere, {p, d}, in.entry, facing, true, kUsual);
        if (chord > 1.01 * kUsual) CHECK(start == kUsual);
    }
    CHECK(told == 0);
    CHECK(grazing > csg_test::share(10000));
}
