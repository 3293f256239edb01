#include "tests/csg/laws.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace csg;
using csg_test::check_hostile;
using csg_test::check_solid;
using csg_test::Rng;

namespace {

const Transform kSkew = Transform::translate({0.1, -0.2, 0.3}) * Transform::rotate_degrees({30, 40, 50}) *
                        Transform::scale({1.0, 0.7, 1.3});

}  // namespace

TEST_CASE("sphere", "[csg][solid]")
{
    check_solid(Sphere{{0.2, 0.1, -0.3}, 1.0});
    check_solid(Sphere{{0, 0, 0}, 1e-6}, {.size = 1.5e-6, .distance = 5.0, .tolerance = 1e-15});
    check_solid(Sphere{{0, 0, 0}, 1e6}, {.size = 1.5e6, .distance = 5e6, .tolerance = 1e-8});
    check_solid(Sphere{{1e6, 0, 0}, 1.0}, {.target = {1e6, 0, 0}, .tolerance = 1e-9});
    check_solid(Sphere{{0, 0, 0}, 1.0}, {.distance = 1e6, .tolerance = 1e-9});
    check_hostile(Sphere{});
    CHECK_FALSE(Sphere{{0, 0, 0}, 0.0}.contains(glm::dvec3(0.0)));
}

TEST_CASE("ellipsoid", "[csg][solid]")
{
    check_solid(Ellipsoid{kSkew});
    check_solid(Ellipsoid{Transform::scale({1, 1e-3, 1})}, {.tolerance = 1e-10});
    check_hostile(Ellipsoid{kSkew});
}

TEST_CASE("box and oriented box", "[csg][solid]")
{
    check_solid(Box{{-1, -0.5, -0.7}, {1, 0.5, 0.8}});
    check_solid(Box{{-1e-6, -1e-6, -1e-6}, {1e-6, 1e-6, 1e-6}}, {.size = 2e-6, .tolerance = 1e-15});
    check_solid(Box{{-1, -1, -1}, {1, 1, 1}}, {.distance = 1e6, .tolerance = 1e-9});
    check_solid(OrientedBox{{-1, -0.5, -0.7}, {1, 0.5, 0.8}, kSkew});
    check_hostile(Box{});
    check_hostile(OrientedBox{{-1, -1, -1}, {1, 1, 1}, kSkew});
}

TEST_CASE("plane and disc", "[csg][solid]")
{
    check_solid(Plane{{0, 1, 0}, 0.3});
    check_solid(Plane{glm::normalize(glm::dvec3(1, 2, 3)), -0.2}, {.tolerance = 1e-11});
    check_solid(Disc::make({0.1, 0, 0}, {1, 1, 0}, 1.0, 0.3, {}), {.tolerance = 1e-11});
    check_hostile(Plane{});
    check_hostile(Disc::make({0, 0, 0}, {0, 0, 1}, 1.0, 0.0, {}));
}

TEST_CASE("cylinder", "[csg][solid]")
{
    check_solid(Cylinder::make({0, 0, 0}, {0.5, 1, 0.2}, 0.6, false, {}));
    check_solid(Cylinder::make({0, 0, 0}, {0, 1, 0}, 0.6, true, {}));
    check_solid(Cylinder::make({0, -1, 0}, {0, 1, 0}, 1.0, false, kSkew));
    check_solid(Cylinder::make({0, -1, 0}, {0, 1, 0}, 1.0, false, {}), {.distance = 1e6, .tolerance = 1e-9});
    check_hostile(Cylinder::make({0, -1, 0}, {0, 1, 0}, 1.0, false, kSkew));
}

TEST_CASE("cone", "[csg][solid]")
{
    Cone cone;
    double radius = 0.0;
    REQUIRE(Cone::make({0, 0, 0}, 1.0, {0, 2, 0}, 0.25, false, {}, cone, radius));
    check_solid(cone);
    check_solid(cone, {.distance = 1e6, .tolerance = 1e-8});
    REQUIRE(Cone::make({0, 0, 0}, 0.0, {0.3, 1, 0}, 0.8, true, kSkew, cone, radius));
    check_solid(cone);
    REQUIRE(Cone::make({0, 0, 0}, 1.0, {0, 2, 0}, -0.5, false, {}, cone, radius));
    CHECK_FALSE(cone.convex());
    CHECK_FALSE(Cone::make({0, 0, 0}, 1.0, {0, 2, 0}, 1.0, false, {}, cone, radius));
    CHECK(radius == 1.0);
    check_hostile(cone);
}

TEST_CASE("torus", "[csg][solid]")
{
    check_solid(Torus{1.0, 0.25, {}});
    check_solid(Torus{1.0, 0.25, kSkew});
    check_solid(Torus{1.0, 0.999, {}}, {.tolerance = 1e-10});
    check_solid(Torus{1e-4, 0.25e-4, {}}, {.size = 1.5e-4, .tolerance = 1e-14});
    check_solid(Torus{1.0, 0.25, {}}, {.distance = 1e6, .tolerance = 1e-9});
    check_solid(Torus{1.0, 1e-3, {}}, {.size = 1.0, .tolerance = 1e-11, .least_hits = 2});
    check_hostile(Torus{1.0, 0.25, kSkew});
}

TEST_CASE("quadric", "[csg][solid]")
{
    check_solid(Quadric{{1, 2, 4}, {0, 0, 0}, {-0.5, 0, 0}, -1.0, {}});
    check_solid(Quadric{{1, 0.5, 2}, {0.3, -0.2, 0.1}, {0.1, 0.2, 0.3}, -1.0, kSkew}, {.tolerance = 1e-11});
    check_solid(Quadric{{1, 1, -1}, {0, 0, 0}, {0, 0, 0}, -0.1, {}}, {.tolerance = 1e-8});  // far ends along a ruling
    check_solid(Quadric{{1, 0, 1}, {0, 0, 0}, {0, -1, 0}, 0.0, {}}, {.tolerance = 1e-8});
    check_hostile(Quadric{{1, 2, 4}, {0, 0, 0}, {-0.5, 0, 0}, -1.0, {}});
    check_hostile(Quadric{});
}

TEST_CASE("rays along axes and edges", "[csg][solid]")
{
    FixedSpans<8> spans;
    intersect(Box{{-1, -1, -1}, {1, 1, 1}}, Ray{{-5, 1, 1}, {1, 0, 0}}, spans);  // along an edge: closed
    REQUIRE(spans.size() == 1);
    CHECK(spans[0].in.t == 4.0);
    spans.clear();
    intersect(Box{{-1, -1, -1}, {1, 1, 1}}, Ray{{-5, 1.0000001, 1}, {1, 0, 0}}, spans);
    CHECK(spans.empty());
    intersect(Torus{1.0, 0.25, {}}, Ray{{0, 0, -5}, {0, 0, 1}}, spans);
    REQUIRE(spans.size() == 2);
    CHECK(spans[0].in.t == Approx(3.75).epsilon(1e-15));
    CHECK(spans[1].out.t == Approx(6.25).epsilon(1e-15));
    spans.clear();
    intersect(Torus{1.0, 0.25, {}}, Ray{{1, 5, 0}, {0, -1, 0}}, spans);
    REQUIRE(spans.size() == 1);
    CHECK(spans[0].in.t == Approx(4.75).epsilon(1e-15));
    spans.clear();
    intersect(Torus{1.0, 0.25, {}}, Ray{{0, 5, 0}, {0, -1, 0}}, spans);  // through the hole
    CHECK(spans.empty());
    const Cylinder tube = Cylinder::make({0, 0, 0}, {0, 0, 1}, 1.0, false, {});
    intersect(tube, Ray{{0.5, 0, -5}, {0, 0, 1}}, spans);
    REQUIRE(spans.size() == 1);
    CHECK(spans[0].in.t == 5.0);
    CHECK(spans[0].out.t == 6.0);
}

TEST_CASE("a zero-thickness box is a sheet whose exit face is generated last", "[csg][solid]")
{
    FixedSpans<8> spans;
    intersect(Box{{-1, -1, 0}, {1, 1, 0}}, Ray{{0.2, 0.3, -3}, {0, 0, 1}}, spans);
    REQUIRE(spans.size() == 1);
    CHECK(spans[0].in.t == 3.0);
    CHECK(spans[0].out.t == 3.0);
    CHECK(spans[0].out.face == kMaxZ);
}

namespace {

/// A wavy ring around the middle, and its hole: pieces of one degree.
std::shared_ptr<const OutlineShape> ring(std::uint32_t seed, int degree)
{
    Rng rng(seed);
    std::vector<OutlinePiece> pieces;
    const auto loop = [&](double radius, bool backward) {
        constexpr int kCorners = 7;
        std::vector<glm::dvec2> corners;
        for (int i = 0; i < kCorners; ++i) {
            const double angle = 2.0 * 3.14159265358979 * (backward ? -i : i) / kCorners;
            corners.push_back(radius * rng.uniform(0.85, 1.15) * glm::dvec2(std::cos(angle), std::sin(angle)));
        }
        for (int i = 0; i < kCorners; ++i) {
            const auto at = [&](int k) { return corners[static_cast<std::size_t>((i + k + kCorners) % kCorners)]; };
            const glm::dvec2 p = at(-1), q = at(0), r = at(1), s = at(2);
            if (degree == 1) pieces.push_back(OutlinePiece::line(q, r));
            else if (degree == 2) pieces.push_back(OutlinePiece::quadratic(q, 0.55 * (q + r), r));
            else
                pieces.push_back(
                    {-0.5 * p + 1.5 * q - 1.5 * r + 0.5 * s, p - 2.5 * q + 2.0 * r - 0.5 * s, 0.5 * (r - p), q, q, r});
        }
    };
    loop(1.2, false);
    loop(0.4, true);
    return std::make_shared<OutlineShape>(pieces);
}

}  // namespace

TEST_CASE("extrusion: the laws of a solid for outlines of every degree, with a hole", "[csg][solid]")
{
    for (const int degree : {1, 2, 3})
        for (std::uint32_t seed = 0; seed < 6; ++seed) {
            INFO("degree " << degree << ", outline " << seed);
            Rng rng(seed + 77);
            const Transform frame = csg_test::random_transform(rng);
            Extrusion solid;
            solid.shape = ring(seed, degree);
            solid.low = -0.4;
            solid.high = 0.5;
            solid.frame = frame;
            check_solid(solid, {.target = frame.offset, .tolerance = 1e-11});
        }
}

TEST_CASE("extrusion: a region counts every joint once", "[csg][solid]")
{
    // Rows through the corners: POV-Ray 3.7 misses the end at some of them (spec 5b, 6.3).
    const glm::dvec2 corner[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    std::vector<OutlinePiece> pieces;
    for (std::size_t i = 0; i < 4; ++i) pieces.push_back(OutlinePiece::line(corner[i], corner[(i + 1) % 4]));
    const OutlineShape diamond(pieces);
    CHECK(diamond.contains({0.2, 0.0}));
    CHECK(diamond.contains({-0.99, 0.0}));
    CHECK_FALSE(diamond.contains({1.01, 0.0}));
    CHECK_FALSE(diamond.contains({-1.01, 0.0}));
    CHECK_FALSE(diamond.contains({0.1, 1.0}));
    CHECK(diamond.contains({0.0, 0.999}));
}
