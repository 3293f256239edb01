#include "tests/csg/residual.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace csg;
using csg_test::Rng;

namespace {

struct Check {
    glm::dvec3 target{0.0};       ///< rays pass near it
    double size = 1.5;            ///< within this distance
    double distance = 5.0;        ///< from so far away
    double tolerance = 1e-12;     ///< of a crossing from the surface, in the solid's own units
    int least_hits = 200;         ///< of 2000 rays, so that a test cannot pass by missing
};

bool within(const Aabb& box, const glm::dvec3& p, double slack)
{
    for (int i = 0; i < 3; ++i)
        if (!(p[i] >= box.lower[i] - slack && p[i] <= box.upper[i] + slack)) return false;
    return true;
}

/// The laws of any solid: crossings lie on the surface, span middles are inside, points just beyond are not, bounds hold
/// every span, normals have unit length and point out, and scaling the direction scales the parameter.
template <class T>
void check_solid(const T& solid, const Check& how = {})
{
    int hits = 0;
    const double just = 1e-6 * how.size;  // beyond an end; spans and gaps shorter than that prove nothing
    const double rounding = 4e-16 * (how.distance + glm::length(how.target));
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const Ray ray = csg_test::ray_near(rng, how.target, how.size, rng.coin() ? how.distance : 0.5 * how.size);
        FixedSpans<8> spans;
        intersect(solid, ray, spans);
        for (std::uint32_t i = 0; i < spans.size(); ++i) {
            ++hits;
            const Span& span = spans[i];
            for (const Crossing& end : {span.in, span.out}) {
                if (!std::isfinite(end.t)) continue;
                REQUIRE(csg_test::residual(solid, ray, end.t, end.face) <= how.tolerance);
                REQUIRE(within(solid.bounds(), ray.at(end.t), 4.0 * rounding + how.tolerance * how.size));
                const glm::dvec3 n = solid.normal(ray.at(end.t), end.face);
                REQUIRE(glm::length(n) == Approx(1.0).epsilon(1e-12));
                const double along = glm::dot(n, ray.direction);  // 1e-4: a grazing ray's crossing is that far off
                if (end.face != kUndrawnFace) REQUIRE((end.t == span.in.t ? along <= 1e-4 : along >= -1e-4));
            }
            const double first = std::max(span.in.t, -1e3 * how.distance), last = std::min(span.out.t, 1e3 * how.distance);
            if (last - first > 4.0 * just) {
                REQUIRE(solid.contains(ray.at(0.5 * (first + last))));
                REQUIRE_FALSE(solid.contains_inverted(ray.at(0.5 * (first + last))));
            }
            const bool gap_before = i == 0 || span.in.t - spans[i - 1].out.t > 2.0 * just;
            if (std::isfinite(span.in.t) && gap_before) REQUIRE_FALSE(solid.contains(ray.at(span.in.t - just)));
            const bool gap_after = i + 1 == spans.size() || spans[i + 1].in.t - span.out.t > 2.0 * just;
            if (std::isfinite(span.out.t) && gap_after) REQUIRE_FALSE(solid.contains(ray.at(span.out.t + just)));
        }
        // Points along the ray agree with the spans, where they are clear of an end.
        for (int k = 0; k < 8; ++k) {
            const double t = rng.uniform(-2.0, 2.0) * how.size + (k % 2 ? how.distance : 0.0);
            bool clear = true;
            for (const Span& span : spans)
                clear = clear && std::abs(t - span.in.t) > just && std::abs(t - span.out.t) > just;
            if (clear) REQUIRE(spans.contains(t) == solid.contains(ray.at(t)));
        }
        FixedSpans<8> slow;
        intersect(solid, Ray{ray.origin, 0.25 * ray.direction}, slow);
        REQUIRE(slow.size() == spans.size());
        for (std::uint32_t i = 0; i < spans.size(); ++i)
            if (std::isfinite(spans[i].in.t))
                REQUIRE(slow[i].in.t == Approx(4.0 * spans[i].in.t).margin(1e-9 * how.size + 1e3 * rounding));
    }
    REQUIRE(hits >= how.least_hits);
}

/// Whatever is asked, no NaN comes back.
template <class T>
void check_hostile(const T& solid)
{
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = kInfinity;
    const double values[] = {0.0, -0.0, 1.0, -1.0, 1e-320, 1e308, -1e308, inf, -inf, nan, 1e-160};
    Rng rng(7);
    for (int k = 0; k < 4000; ++k) {
        Ray ray{};
        for (int i = 0; i < 3; ++i) {
            ray.origin[i] = values[rng.below(11)];
            ray.direction[i] = values[rng.below(11)];
        }
        FixedSpans<8> spans;
        intersect(solid, ray, spans);
        for (const Span& span : spans) REQUIRE(span.in.t <= span.out.t);
    }
}

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
    CHECK_FALSE(Sphere{{0, 0, 0}, 0.0}.contains({0, 0, 0}));
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
            else pieces.push_back({-0.5 * p + 1.5 * q - 1.5 * r + 0.5 * s, p - 2.5 * q + 2.0 * r - 0.5 * s, 0.5 * (r - p), q, q, r});
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

namespace {

/// Place of a term in POV-Ray's order, found by counting.
std::size_t term(int degree, int x, int y, int z)
{
    std::size_t at = 0;
    for (int i = degree; i >= 0; --i)
        for (int j = degree - i; j >= 0; --j)
            for (int k = degree - i - j; k >= 0; --k, ++at)
                if (i == x && j == y && k == z) return at;
    return at;
}

}  // namespace

TEST_CASE("polynomial: the laws of a solid, from degree 3 to 8", "[csg][solid]")
{
    for (int degree = 3; degree <= 8; ++degree)
        for (std::uint32_t seed = 0; seed < 3; ++seed) {
            INFO("degree " << degree << ", seed " << seed);
            Rng rng(1000u * static_cast<std::uint32_t>(degree) + seed);
            std::vector<double> c(static_cast<std::size_t>((degree + 1) * (degree + 2) * (degree + 3) / 6));
            for (double& v : c) v = rng.uniform(-0.1, 0.1);
            // Closed around the middle where the degree is even, open where it is odd.
            for (const int axis : {0, 1, 2}) c[term(degree, axis == 0 ? degree : 0, axis == 1 ? degree : 0, axis == 2 ? degree : 0)] += 1.0;
            c.back() -= 1.0;
            const Transform frame = csg_test::random_transform(rng);
            check_solid(Polynomial{std::make_shared<PolynomialShape>(degree, c), frame}, {.target = frame.offset, .tolerance = 1e-10});
        }
}

TEST_CASE("polynomial: a torus as a quartic meets rays where the torus does", "[csg][solid]")
{
    const double major = 1.0, minor = 0.3, r2 = major * major, k = r2 - minor * minor;
    std::vector<double> c(35);
    // (x^2 + y^2 + z^2 + k)^2 - 4 r2 (x^2 + z^2)
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) {
            const auto power = [&](int axis) { return 2 * (a == axis) + 2 * (b == axis); };
            c[term(4, power(0), power(1), power(2))] += 1.0;
        }
    for (int a = 0; a < 3; ++a) c[term(4, 2 * (a == 0), 2 * (a == 1), 2 * (a == 2))] += 2.0 * k - (a == 1 ? 0.0 : 4.0 * r2);
    c[34] += k * k;
    const Polynomial quartic{std::make_shared<PolynomialShape>(4, c), {}};
    const Torus torus{major, minor, {}};
    int met = 0;
    for (std::uint32_t seed = 0; seed < 4000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const Ray ray = csg_test::ray_near(rng, glm::dvec3(0.0), 1.4, 6.0);
        FixedSpans<20> by_polynomial;
        FixedSpans<4> by_torus;
        quartic.intersect(ray, by_polynomial);
        torus.intersect(ray, by_torus);
        REQUIRE(by_polynomial.size() == by_torus.size());
        for (std::uint32_t i = 0; i < by_torus.size(); ++i, ++met) {
            REQUIRE(by_polynomial[i].in.t == Approx(by_torus[i].in.t).epsilon(1e-9));
            REQUIRE(by_polynomial[i].out.t == Approx(by_torus[i].out.t).epsilon(1e-9));
        }
    }
    CHECK(met > 1000);
}
