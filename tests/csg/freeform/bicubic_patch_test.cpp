#include "csg/freeform/surface/bicubic_patch.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <optional>

#include <cmath>

using namespace csg;
using csg_test::Rng;

namespace {

BicubicPatch::Input random_patch(Rng& rng)
{
    BicubicPatch::Input input;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            input.points[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = glm::dvec3(i, j, 0) +
                                                                                     rng.point(0.3);
    input.u_steps = rng.below(7);
    input.v_steps = rng.below(7);
    if (rng.coin()) input.flatness = rng.uniform(0.0, 0.2);
    return input;
}

/// The surface by its definition.
glm::dvec3 surface(const BicubicPatch::Points& c, double u, double v)
{
    const auto bernstein = [](int k, double t) {
        return (k == 1 || k == 2 ? 3.0 : 1.0) * std::pow(t, k) * std::pow(1.0 - t, 3 - k);
    };
    glm::dvec3 sum(0.0);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            sum += bernstein(i, u) * bernstein(j, v) * c[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    return sum;
}

}  // namespace

TEST_CASE("what is met of a patch lies where its uv says", "[csg][patch]")
{
    int met = 0;
    constexpr std::uint32_t kPatches = csg_test::share(100), kRays = 20;  // making a patch takes as long as 400 rays
    std::optional<BicubicPatch> patch;
    BicubicPatch::Input input;
    for (std::uint32_t seed = 0; seed < kPatches * kRays; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        if (seed % kRays == 0) {
            input = random_patch(rng);
            input.flatness = 0.0;
            input.u_steps = input.v_steps = 6;
            patch.emplace(input);
            CHECK(patch->pieces() == 4096);
        }
        const glm::dvec3 aim = surface(input.points, rng.uniform(0.05, 0.95), rng.uniform(0.05, 0.95));
        const glm::dvec3 way = glm::normalize(glm::dvec3(rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3), 1.0));
        const Ray ray{aim - 5.0 * way, way};
        IntersectionList record(0.0, kInfinity, false);
        patch->intersect(ray, record);
        record.each_touching([&](double t, std::uint32_t face) {
            ++met;
            const glm::dvec3 p = ray.at(t);
            const glm::dvec2 uv = patch->uv(p, face);                          // u runs along the columns
            CHECK(glm::length(surface(input.points, uv.y, uv.x) - p) < 2e-3);  // half the sag of a piece 1/64 wide
        });
    }
    CHECK(met >= csg_test::share(2000));
}

TEST_CASE("every piece of a patch is flat or halved to the end", "[csg][patch]")
{
    for (std::uint32_t seed = 0; seed < csg_test::share(300); ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        BicubicPatch::Input input = random_patch(rng);
        const std::size_t most = std::size_t{1} << (input.u_steps + input.v_steps);
        const std::size_t pieces = BicubicPatch(input).pieces();
        CHECK(pieces <= most);
        input.flatness = 0.0;
        CHECK(BicubicPatch(input).pieces() == most);
        input.flatness = 1e9;
        CHECK(BicubicPatch(input).pieces() == 1);
    }
}

TEST_CASE("numbers that are none leave a patch unharmed", "[csg][patch]")
{
    const double odd[] = {0.0, -0.0, 1.0, 1e300, -1e300, kInfinity, -kInfinity, std::nan("")};
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        Rng rng(seed);
        BicubicPatch::Input input = random_patch(rng);
        input.u_steps = input.v_steps = 2;
        for (auto& row : input.points)
            for (glm::dvec3& p : row)
                if (rng.below(8) == 0) p[rng.below(3)] = odd[rng.below(8)];
        const BicubicPatch patch(input);
        IntersectionList record(0.0, kInfinity, rng.coin());
        patch.intersect({rng.point(3.0), rng.direction()}, record);
        patch.intersect({{odd[rng.below(8)], 0, 0}, {odd[rng.below(8)], 1, odd[rng.below(8)]}}, record);
        record.each_touching([&](double, std::uint32_t face) { CHECK_NOTHROW(patch.gradient({0, 0, 0}, face)); });
    }
}
