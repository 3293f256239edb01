#include "tests/csg/degrees.h"
#include "tests/csg/laws.h"

using namespace csg;
using csg_test::check_solid;
using csg_test::Rng;

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
    csg_test::each_degree(3, 8, csg_test::share(3), [](int degree, Rng& rng) {
        std::vector<double> c(static_cast<std::size_t>((degree + 1) * (degree + 2) * (degree + 3) / 6));
        for (double& v : c) v = rng.uniform(-0.1, 0.1);
        // Closed around the middle where the degree is even, open where it is odd.
        for (const int axis : {0, 1, 2})
            c[term(degree, axis == 0 ? degree : 0, axis == 1 ? degree : 0, axis == 2 ? degree : 0)] += 1.0;
        c.back() -= 1.0;
        const Transform frame = csg_test::random_transform(rng);
        check_solid(Polynomial{std::make_shared<PolynomialShape>(degree, c), frame},
                    {.target = frame.offset, .tolerance = 1e-10});
    });
}

TEST_CASE("polynomial: the laws of a solid where the leading coefficient along a ray is small", "[csg][solid]")
{
    // Along <1, 1, 1> x^35 leaves 1e-8 of itself; the odd ones have far crossings where it nearly cancels.
    for (const int degree : {15, 20, 34, 35}) {
        INFO("degree " << degree);
        std::vector<double> c(static_cast<std::size_t>((degree + 1) * (degree + 2) * (degree + 3) / 6));
        c[term(degree, degree, 0, 0)] = c[term(degree, 0, degree, 0)] = c[term(degree, 0, 0, degree)] = 1.0;
        c[term(degree, 1, 1, 1)] = 0.3;
        c.back() = -0.7;
        check_solid(Polynomial{std::make_shared<PolynomialShape>(degree, c), Transform::rotate_degrees({30, 40, 50})},
                    {.tolerance = 1e-12,
                     .rays = csg_test::share(400),
                     .least_hits = csg_test::share(40)});  // measured: 1e-13; 1e-10 by the powers of t alone
    }
}

TEST_CASE("polynomial: one 10000 units wide has coefficients 1e16 times its first", "[csg][solid]")
{
    std::vector<double> c(35);
    c[term(4, 4, 0, 0)] = c[term(4, 0, 4, 0)] = c[term(4, 0, 0, 4)] = 1.0;
    c.back() = -1e16;
    check_solid(Polynomial{std::make_shared<PolynomialShape>(4, c), {}},
                {.size = 1.2e4, .distance = 5e4, .tolerance = 1e-8});
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
    for (int a = 0; a < 3; ++a)
        c[term(4, 2 * (a == 0), 2 * (a == 1), 2 * (a == 2))] += 2.0 * k - (a == 1 ? 0.0 : 4.0 * r2);
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

TEST_CASE("polynomial: the box of a high degree is nearly as tight as can be", "[csg][solid]")
{
    for (const int degree : {6, 8, 10, 12}) {
        INFO("degree " << degree);
        std::vector<double> c(static_cast<std::size_t>((degree + 1) * (degree + 2) * (degree + 3) / 6));
        c[term(degree, degree, 0, 0)] = c[term(degree, 0, degree, 0)] = c[term(degree, 0, 0, degree)] = 1.0;
        c[term(degree, 2, 2, 2)] = -1.7;
        c[term(degree, 3, 1, 0)] = 0.5;
        c[term(degree, 0, 1, 4)] = -0.3;
        c.back() = -0.4;
        const PolynomialShape shape(degree, c);
        glm::dvec3 most(0.0);
        Rng rng(1);
        for (int i = 0; i < 200'000; ++i) {
            const glm::dvec3 p{rng.uniform(-1.5, 1.5), rng.uniform(-1.5, 1.5), rng.uniform(-1.5, 1.5)};
            if (shape.value(p) <= 0.0) most = glm::max(most, glm::abs(p));
        }
        for (int axis = 0; axis < 3; ++axis) {
            const double reach = std::max(shape.box().upper[axis], -shape.box().lower[axis]);
            CHECK(reach > most[axis]);
            CHECK(reach < 1.25 * most[axis]);
        }
    }
}

TEST_CASE("polynomial: the box of what has an end is near it, and holds it", "[csg][solid]")
{
    // (x^2 + y^2 + z^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2), a torus.
    const double R = 3.0, r = 1.0, e = R * R - r * r;
    std::vector<double> c(35, 0.0);
    c[term(4, 4, 0, 0)] = c[term(4, 0, 4, 0)] = c[term(4, 0, 0, 4)] = 1.0;
    c[term(4, 2, 2, 0)] = c[term(4, 2, 0, 2)] = c[term(4, 0, 2, 2)] = 2.0;
    c[term(4, 2, 0, 0)] = c[term(4, 0, 0, 2)] = 2.0 * e - 4.0 * R * R;
    c[term(4, 0, 2, 0)] = 2.0 * e;
    c[term(4, 0, 0, 0)] = e * e;
    const Aabb box = PolynomialShape(4, c).box();
    CHECK(box.lower.x <= -4.0);
    CHECK(box.upper.z >= 4.0);
    CHECK(box.upper.y >= 1.0);
    CHECK(box.upper.x < 5.5);
    CHECK(box.upper.y < 5.5);
    // With an end to some sides only, or none: no box.
    c[term(4, 0, 0, 4)] = 0.0;
    CHECK(!PolynomialShape(4, c).box().finite());
    c[term(4, 0, 0, 4)] = -1.0;
    CHECK(!PolynomialShape(4, c).box().finite());
    std::vector<double> cubic(20, 0.0);
    cubic[0] = 1.0;
    CHECK(!PolynomialShape(3, cubic).box().finite());
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const int degree = 2 * (1 + rng.below(3));
        std::vector<double> any(static_cast<std::size_t>((degree + 1) * (degree + 2) * (degree + 3) / 6));
        for (double& v : any) v = rng.uniform(-1.0, 1.0);
        for (const int axis : {0, 1, 2})
            any[term(degree, axis == 0 ? degree : 0, axis == 1 ? degree : 0, axis == 2 ? degree : 0)] +=
                rng.uniform(0.0, 4.0);
        const PolynomialShape shape(degree, any);
        if (!shape.box().finite()) continue;
        for (int i = 0; i < 300; ++i) {
            const glm::dvec3 p = rng.direction() * std::exp(rng.uniform(-2.0, 6.0));
            const bool within = glm::all(glm::lessThanEqual(shape.box().lower, p)) &&
                                glm::all(glm::lessThanEqual(p, shape.box().upper));
            if (!within) CHECK(shape.value(p) > 0.0);
        }
    }
}
