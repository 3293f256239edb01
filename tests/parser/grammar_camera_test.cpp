#include "tests/parser/grammar_support.h"

#include <catch2/catch.hpp>

#include <cmath>

using grammar_test::parsed;

namespace {

/// Direction of the ray through the centre of a pixel of a 4x3 picture, as the real program printed them: the corner
/// pixel (0, 0) lies at x = -3/8, y = 1/3 of right and up.
glm::dvec3 corner_ray(const scene::Camera& c) { return c.direction - 0.375 * c.right + c.up / 3.0; }
void check_near(const glm::dvec3& a, const glm::dvec3& b, double within)
{
    INFO(a.x << " " << a.y << " " << a.z << " against " << b.x << " " << b.y << " " << b.z);
    CHECK(glm::distance(a, b) < within);
}
/// Where the corner ray meets the plane z = 10.
glm::dvec2 hit_at_ten(const std::string& block)
{
    const scene::Camera c = parsed("#version 3.1;\ncamera { " + block + " }").camera;
    const glm::dvec3 d = corner_ray(c);
    const double t = (10.0 - c.location.z) / d.z;
    return {c.location.x + t * d.x, c.location.y + t * d.y};
}

}  // namespace

TEST_CASE("the default camera", "[parser][camera]")
{
    const scene::Camera c = parsed("").camera;
    CHECK(c.right == glm::dvec3(1.33, 0, 0));
    CHECK(c.focal_distance == 1.0);
    CHECK(c.variance == 1e-4);
}

TEST_CASE("from version 3.5 the order of items does not matter", "[parser][camera]")
{
    const auto camera = [](const char* items) { return parsed(std::string("camera { ") + items + " }").camera; };
    check_near(corner_ray(camera("angle 60 right 2*x")), corner_ray(camera("right 2*x angle 60")), 1e-12);
    check_near(corner_ray(camera("rotate z*90 angle 30")), corner_ray(camera("angle 30 rotate z*90")), 1e-12);
    check_near(corner_ray(camera("look_at 0 location -5*z")), corner_ray(camera("location -5*z look_at 0")), 1e-12);
    CHECK(camera("direction 3*z").focal_distance == 1.0);
    CHECK(camera("direction 3*z look_at z").focal_distance == Approx(3.0));
    CHECK(camera("angle 60").focal_distance == Approx(1.1518).margin(1e-4));
}

TEST_CASE("3.8 divides by lengths where it looks at a point, 3.7 multiplies by the reciprocal", "[parser][camera]")
{
    // Half of these bits differ; what 3.8 shows of the plane y = 0 tells them (camera_rays_test.cpp).
    const std::string block = "camera { location <50, 55, -75> look_at <-10, 18, 0> }";
    const glm::dvec3 newer = parsed("#version 3.8;\n" + block).camera.direction;
    CHECK(newer == glm::dvec3(-0x1.2a76a7ea28bd8p-1, -0x1.701ae02954612p-2, 0x1.751451e4b2ecdp-1));
    const glm::dvec3 older = parsed("#version 3.7;\n" + block).camera.direction;
    CHECK(older == glm::dvec3(-0x1.2a76a7ea28bd8p-1, -0x1.701ae02954613p-2, 0x1.751451e4b2ecep-1));
}

TEST_CASE("an upside-down up mirrors the picture", "[parser][camera]")
{
    const scene::Camera c = parsed("camera { up -y look_at x }").camera;
    check_near(c.up, {0, 1, 0}, 1e-12);
    check_near(glm::normalize(c.right), {0, 0, 1}, 1e-12);
}

TEST_CASE("orthographic sizes", "[parser][camera]")
{
    const auto corner = [](const char* items) {
        const scene::Camera c = parsed(std::string("camera { ") + items + " }").camera;
        return glm::dvec2(-0.375 * c.right.x, c.up.y / 3.0);
    };
    const auto check = [&](const char* items, double x, double y) {
        INFO(items);
        CHECK(corner(items).x == Approx(x).margin(1.5e-3));
        CHECK(corner(items).y == Approx(y).margin(1.5e-3));
    };
    check("orthographic", -0.499, 0.334);
    check("orthographic right 4*x", -1.5, 0.334);
    check("orthographic angle 90", -0.75, 0.501);
    check("orthographic right 8*x up 6*y angle 90", -0.75, 0.5);
    check("orthographic location -10*z", -5.486, 3.667);
    check("orthographic location -10*z look_at 0", -4.988, 3.333);
    check("orthographic location -10*z look_at 0 angle 60", -4.330, 2.894);
    check("orthographic location -10*z look_at 0 direction 5*z", -0.998, 0.667);
    check("orthographic location -10*z look_at 0 up 2*y", -0.499, 0.667);
}

TEST_CASE("before version 3.5 items act where they stand", "[parser][camera]")
{
    CHECK(hit_at_ten("angle 60 right 2*x").x == Approx(-6.512).margin(1e-3));
    CHECK(hit_at_ten("angle 60 right 2*x").y == Approx(2.894).margin(1e-3));
    CHECK(hit_at_ten("right 2*x angle 60").x == Approx(-4.330).margin(1e-3));
    CHECK(hit_at_ten("rotate z*90 right 2*x").x == Approx(-10.834).margin(2e-3));
}

TEST_CASE("a declared camera takes only transformations", "[parser][camera]")
{
    CHECK(parsed("#declare C = camera { location z }\ncamera { C translate x }").camera.location ==
          glm::dvec3(1, 0, 1));
    CHECK(grammar_test::error_of("#declare C = camera { location z }\ncamera { C location x }") ==
          "2:12: error: expected an item of 'camera' or '}', found 'location'");
}
