#include "csg/tree/boxes/quadric_box.h"
#include "support.h"

#include <catch2/catch.hpp>

using namespace csg;
using csg_test::Rng;

namespace {

/// -1, 0 or 1, or a number between 0.2 and 2 of either sign.
double coefficient(Rng& rng)
{
    return rng.coin() ? rng.below(3) - 1.0 : (rng.coin() ? 1.0 : -1.0) * rng.uniform(0.2, 2.0);
}

Plane random_plane(Rng& rng, const Transform& frame)
{
    glm::dvec3 local(0.0);
    local[rng.below(3)] = rng.coin() ? 1.0 : -1.0;
    const glm::dvec3 normal = rng.below(4) == 0 ? rng.direction() : glm::normalize(frame.normal(local));
    return {normal, glm::dot(normal, frame.offset) + rng.uniform(-0.5, 3.0)};
}

bool in(const Aabb& box, const glm::dvec3& p)
{
    return glm::all(glm::greaterThanEqual(p, box.lower)) && glm::all(glm::lessThanEqual(p, box.upper));
}

}  // namespace

TEST_CASE("the box of a quadric between planes holds every point of it", "[csg][bounds]")
{
    int narrowed = 0;
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        Quadric quadric;
        for (int i = 0; i < 3; ++i)
            quadric.square[i] = coefficient(rng), quadric.linear[i] = rng.coin() ? 0.0 : coefficient(rng);
        quadric.constant = coefficient(rng);
        quadric.frame = csg_test::random_transform(rng);
        std::vector<Plane> planes;
        for (int i = rng.below(5); i >= 0; --i) planes.push_back(random_plane(rng, quadric.frame));
        const Aabb box = quadric_box(quadric, planes, Aabb::everything());
        narrowed += box.finite();
        if (!box.finite()) continue;
        for (int k = 0; k < 500; ++k) {
            const glm::dvec3 p = quadric.frame.point(rng.point(rng.coin() ? 3.0 : 30.0));
            bool inside = quadric.contains(p);
            for (const Plane& plane : planes) inside = inside && glm::dot(plane.normal_out, p) <= plane.offset;
            if (inside) REQUIRE(in(box, p));
        }
    }
    CHECK(narrowed > 200);
}

TEST_CASE("a waist between two planes is as wide as at the farther one", "[csg][bounds]")
{
    Quadric waist;  // x^2 - y^2 + z^2 = 1, scaled by 0.6 across and shifted
    waist.square = {1, -1, 1};
    waist.constant = -1;
    waist.frame = Transform::translate({0, 5, 0}) * Transform::scale({0.6, 1.4, 0.6});
    const Aabb box = quadric_box(waist, {{{0, 1, 0}, 5.5}, {{0, -1, 0}, -3.0}}, Aabb::everything());
    const double wide = 0.6 * std::sqrt(1.0 + (2.0 / 1.4) * (2.0 / 1.4));
    CHECK(box.lower.x == Approx(-wide).epsilon(1e-6));
    CHECK(box.upper.z == Approx(wide).epsilon(1e-6));
    CHECK(box.lower.y == Approx(3.0).epsilon(1e-6));
    CHECK(box.upper.y == Approx(5.5).epsilon(1e-6));
}
