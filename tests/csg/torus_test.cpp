#include "tests/csg/residual.h"
#include "tests/csg/support.h"
#include "tests/csg/tube_ray.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace csg;
using csg_test::Rng;
using csg_test::tube_ray;

namespace {

/// The torus along a ray in its own frame, unscaled.
csg::detail::TorusRay<> along(const Torus& torus, const Ray& ray)
{
    const glm::dvec3 foot = ray.origin - glm::dot(ray.origin, ray.direction) * ray.direction;
    const glm::dvec3& d = ray.direction;
    csg::detail::TorusRay<> made{foot.x, foot.y, foot.z, d.x, d.y, d.z, torus.major, torus.minor};
    made.expand();
    return made;
}

}  // namespace

TEST_CASE("torus by factors and by search find the same crossings", "[csg][solid]")
{
    int by_factors = 0;
    for (const double minor : {0.005, 0.1, 0.25, 0.6, 0.999, 1.01, 1.3, 3.0}) {
        const Torus torus{1.0, minor, {}};
        for (std::uint32_t seed = 0; seed < 4000; ++seed) {
            INFO("minor " << minor << ", seed " << seed);
            Rng rng(seed);
            const csg::detail::TorusRay<> ray = along(torus, tube_ray(rng, torus, seed % 4 == 0));
            const csg::detail::QuarticFactors<double> fast = csg::detail::torus_by_factors(ray);
            double sure[4];
            if (!fast.safe) continue;
            const int n = fast.four ? 4 : fast.two ? 2 : 0;
            ++by_factors;
            REQUIRE(csg::detail::torus_by_search(ray, -1.1 - minor, 1.1 + minor, sure) == n);
            for (int i = 0; i < n; ++i) {
                REQUIRE(std::abs(fast.roots[i] - sure[i]) < 1e-6 * minor);  // where the ray grazes; else far closer
                REQUIRE(csg_test::residual(torus, {{ray.px, ray.py, ray.pz}, {ray.dx, ray.dy, ray.dz}}, fast.roots[i],
                                           0) < 1e-14);
            }
        }
    }
    CHECK(by_factors > 22000);  // nearly all that are not tangent
}

TEST_CASE("torus: rays along its axis and in its plane", "[csg][solid]")
{
    const Torus torus{1.0, 0.25, {}};
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const double x = rng.uniform(-1.4, 1.4), z = rng.uniform(-1.4, 1.4);
        double t[4];
        const double from_tube = std::abs(std::sqrt(x * x + z * z) - 1.0);
        REQUIRE(torus.roots({{x, 5.0, z}, {0.0, -1.0, 0.0}}, t) == (from_tube < 0.25 ? 2 : 0));
        const double miss = std::abs(x);  // distance of the second ray from the axis
        const int n = torus.roots({{x, 0.0, -5.0}, {0.0, 0.0, 1.0}}, t);
        REQUIRE(n == (miss < 0.75 ? 4 : miss < 1.25 ? 2 : 0));
        if (n > 0) REQUIRE(t[0] == Approx(5.0 - std::sqrt(1.5625 - x * x)).epsilon(1e-14));
    }
}

TEST_CASE("torus: crossings of tangent rays lie on the surface", "[csg][solid]")
{
    for (const double minor : {1e-4, 0.01, 0.25, 0.9, 1.3}) {
        const Torus torus{1.0, minor, {}};
        for (std::uint32_t seed = 0; seed < 2000; ++seed) {
            INFO("minor " << minor << ", seed " << seed);
            Rng rng(seed);
            const Ray ray = tube_ray(rng, torus, true);
            double t[4];
            const int n = torus.roots(ray, t);
            REQUIRE(n % 2 == 0);
            for (int i = 0; i < n; ++i) REQUIRE(csg_test::residual(torus, ray, t[i], 0) < 1e-13);
            for (int i = 0; i < n; i += 2) REQUIRE(t[i] <= t[i + 1]);
            if (n == 4 && !(t[1] <= t[2])) {
                REQUIRE(torus.spindle());
                REQUIRE((t[0] <= t[2] && t[3] <= t[1]));
            }
        }
    }
}
