#include "render/solid/measure/measure.h"
#include "tests/render/solid/body_of.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace {

constexpr double kPi = 3.14159265358979323846;

struct Known {
    const char* scene;
    double volume, surface;
};

}  // namespace

TEST_CASE("volume and surface are those of the formulas, within the error told", "[solid]")
{
    const Known known[] = {
        {"sphere { <5, 1, 2>, 1 }", 4.0 / 3.0 * kPi, 4.0 * kPi},
        {"box { 0, <1, 2, 3> rotate <20, 30, 40> }", 6.0, 22.0},
        {"torus { 1, 0.25 rotate 33 * x }", 2.0 * kPi * kPi * 0.0625, 4.0 * kPi * kPi * 0.25},
        {"cylinder { 0, 2 * y, 0.5 rotate 25 * z }", kPi * 0.5, kPi * 2.5},
        {"difference { box { -1, 1 } sphere { 0, 0.9 } }", 8.0 - 4.0 / 3.0 * kPi * 0.729, 24.0 + 4.0 * kPi * 0.81},
        // Its container cuts it off: these sides count, drawn or not.
        {"isosurface { function { sqrt(x * x + z * z) - 0.5 } max_gradient 2 contained_by { box { <-1, 0, -1>, <1, 2, "
         "1> } } }",
         kPi * 0.5, kPi * 2.5},
        {"isosurface { function { -1 } contained_by { box { -1, 1 } } open }", 8.0, 24.0},
    };
    for (const Known& k : known) {
        INFO(k.scene);
        solid::MeasureOptions options;
        options.precision = 1e-3;
        const solid::Measures found = solid::measure(body_of(k.scene), options);
        CHECK(std::abs(found.volume.value - k.volume) <= found.volume.error);
        CHECK(std::abs(found.surface.value - k.surface) <= found.surface.error);
        CHECK(found.volume.error <= 1e-3 * k.volume);
        CHECK(found.surface.error <= 1e-3 * k.surface);
    }
}

TEST_CASE("centre, inertia and extent of a sphere elsewhere", "[solid]")
{
    const solid::Measures m = solid::measure(body_of("sphere { <5, 1, 2>, 2 }"));
    const double mass = 32.0 / 3.0 * kPi;
    for (int i = 0; i < 3; ++i) {
        CHECK(std::abs(m.centre[i] - glm::dvec3(5, 1, 2)[i]) <= m.centre_error[i]);
        CHECK(std::abs(m.inertia[i][i] - 0.4 * mass * 4.0) <= m.inertia_error);
        CHECK(m.extent.lower[i] == Approx(glm::dvec3(3, -1, 0)[i]).margin(1e-9));
        CHECK(m.extent.upper[i] == Approx(glm::dvec3(7, 3, 4)[i]).margin(1e-9));
    }
}

TEST_CASE("what has no end or no inside is no body", "[solid]")
{
    CHECK_THROWS_AS(solid::measure(body_of("plane { y, 0 }")), solid::NoBody);
    CHECK_THROWS_AS(solid::measure(body_of("triangle { 0, x, y }")), solid::NoBody);
    CHECK_THROWS_AS(solid::measure(body_of("sphere { 0, 1 inverse }")), solid::NoBody);
}
