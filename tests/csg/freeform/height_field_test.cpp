#include "csg/freeform/surface/height_field.h"
#include "csg/freeform/surface/terrain_walk.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace csg;
using csg_test::Rng;

namespace {

HeightField::Grid random_grid(Rng& rng, bool flat_parts)
{
    HeightField::Grid grid;
    grid.columns = static_cast<std::uint32_t>(2 + rng.below(40));
    grid.rows = static_cast<std::uint32_t>(2 + rng.below(40));
    for (std::uint32_t n = 0; n < grid.columns * grid.rows; ++n)
        grid.levels.push_back(static_cast<std::uint16_t>(flat_parts ? 20000 * rng.below(3) : rng.below(65536)));
    if (rng.coin()) grid.water = rng.uniform(0.0, 70000.0);
    return grid;
}

/// A ray through the grid's box; some along axes, over points and along edges.
Ray random_ray(Rng& rng, const HeightField::Grid& grid, int kind)
{
    glm::dvec3 target(rng.uniform(0, 1), rng.uniform(-0.2, 1.2), rng.uniform(0, 1)), way = rng.direction();
    if (kind == 1) {
        target.x = rng.below(static_cast<int>(grid.columns)) / double(grid.columns - 1);
        target.z = rng.below(static_cast<int>(grid.rows)) / double(grid.rows - 1);
    }
    if (kind == 2) way = {0.0, rng.coin() ? 1.0 : -1.0, 0.0};
    if (kind == 3) way[rng.coin() ? 0 : 2] = 0.0;
    if (kind == 4) way.y *= 0.02;
    return {target - 3.0 * way, way};
}

/// The level of the terrain by looking for the triangle.
double level_at(const HeightField::Grid& grid, double x, double z)
{
    const auto i = std::min(static_cast<std::uint32_t>(x), grid.columns - 2),
               k = std::min(static_cast<std::uint32_t>(z), grid.rows - 2);
    const auto h = [&](std::uint32_t a, std::uint32_t b) {
        return static_cast<double>(grid.levels[(k + b) * grid.columns + i + a]);
    };
    const double fx = x - i, fz = z - k;
    return fx + fz <= 1.0 ? h(0, 0) + (h(1, 0) - h(0, 0)) * fx + (h(0, 1) - h(0, 0)) * fz
                          : h(1, 1) + (h(0, 1) - h(1, 1)) * (1.0 - fx) + (h(1, 0) - h(1, 1)) * (1.0 - fz);
}

/// Whether the ground holds the point: below the terrain, or below the water.
bool holds(const HeightField::Grid& grid, const glm::dvec3& p)
{
    const double x = p.x * (grid.columns - 1), z = p.z * (grid.rows - 1);
    if (!(p.x >= 0.0 && p.x <= 1.0 && p.z >= 0.0 && p.z <= 1.0)) return false;
    const double lowest = *std::min_element(grid.levels.begin(), grid.levels.end());
    return p.y * 65536.0 < std::max(std::max(lowest, grid.water) - 0.001, level_at(grid, x, z));
}

}  // namespace

TEST_CASE("a ray is in the ground exactly where its points are", "[csg][height_field]")
{
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const HeightField::Grid grid = random_grid(rng, seed % 3 == 0);
        const HeightField field(grid);
        const Ray ray = random_ray(rng, grid, static_cast<int>(seed % 5));
        IntersectionList record(-kInfinity, kInfinity, false);
        field.intersect(ray, record);
        std::vector<double> ends{0.0, 6.0};
        const auto inside = [&](double t) {
            bool in = false;
            record.each_span([&](double a, std::uint32_t, double b, std::uint32_t) { in = in || (a < t && t < b); });
            return in;
        };
        record.each_span([&](double a, std::uint32_t in_face, double b, std::uint32_t out_face) {
            REQUIRE(a <= b);
            for (const auto& [t, face] : {std::pair(a, in_face), std::pair(b, out_face)}) {
                if (t > 0.0 && t < 6.0) ends.push_back(t);
                if (face == kUndrawnFace) continue;
                const glm::dvec3 p = ray.at(t);
                REQUIRE(std::abs(level_at(grid, p.x * (grid.columns - 1), p.z * (grid.rows - 1)) - 65536.0 * p.y) <
                        1e-6);
                REQUIRE(p.y * 65536.0 > grid.water - 0.002);  // what lies under water is a hole
            }
        });
        std::sort(ends.begin(), ends.end());
        for (std::size_t i = 0; i + 1 < ends.size(); ++i)
            for (const double share : {0.02, 0.3, 0.6, 0.98}) {
                const double t = ends[i] + (ends[i + 1] - ends[i]) * share;
                const glm::dvec3 p = ray.at(t);
                if (ends[i + 1] - ends[i] < 1e-6 || std::min(std::abs(p.x), std::abs(p.x - 1.0)) < 1e-12 ||
                    std::min(std::abs(p.z), std::abs(p.z - 1.0)) < 1e-12)
                    continue;  // as near as rounding
                REQUIRE(inside(t) == holds(grid, p));
            }
    }
}

TEST_CASE("no ray slips between the cells of a flat floor", "[csg][height_field]")
{
    HeightField::Grid grid;
    grid.columns = grid.rows = 65;
    grid.levels.assign(65 * 65, 30000);
    const HeightField field(grid);
    for (std::uint32_t seed = 0; seed < 20000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        // At a point or an edge of the grid, from a place on the grid.
        const glm::dvec3 target((1 + rng.below(63)) / 64.0, 30000.0 / 65536.0,
                                rng.coin() ? rng.uniform(0.1, 0.9) : (1 + rng.below(63)) / 64.0);
        const glm::dvec3 from(rng.below(65) / 64.0, rng.uniform(0.5, 3.0), rng.below(65) / 64.0);
        IntersectionList record(0.0, kInfinity, true);
        field.intersect({from, glm::normalize(target - from)}, record);
        double met = 0.0;
        record.each_span(
            [&](double in, std::uint32_t face, double, std::uint32_t) { met = face == kUndrawnFace ? 0.0 : in; });
        REQUIRE(std::abs(met - glm::length(target - from)) < 1e-9 * met);
    }
}

TEST_CASE("where a ray meets the terrain does not depend on how far it looks", "[csg][height_field]")
{
    int met = 0;
    for (std::uint32_t seed = 0; seed < 20000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const HeightField::Grid grid = random_grid(rng, seed % 3 == 0);
        const HeightField field(grid);
        const Ray ray = random_ray(rng, grid, static_cast<int>(seed % 5));
        const auto nearest = [&](double to) {
            IntersectionList record(0.0, to, true);
            field.intersect(ray, record);
            double t = kInfinity;
            const auto offer = [&](double at, std::uint32_t face) {
                if (at >= 0.0 && at <= to && at < t && face != kUndrawnFace) t = at;
            };
            record.each_span([&](double in, std::uint32_t in_face, double out, std::uint32_t out_face) {
                offer(in, in_face);
                offer(out, out_face);
            });
            return t;
        };
        const double t = nearest(kInfinity);
        if (t == kInfinity) continue;
        ++met;
        // The end lies in the cell of the crossing as a rule.
        for (const double beyond : {1e-12, 1e-6, 1e-3, 1e-2, 0.5}) REQUIRE(nearest(t * (1.0 + beyond)) == t);
    }
    REQUIRE(met > 5000);
}

TEST_CASE("numbers that are none leave a height field unharmed", "[csg][height_field]")
{
    HeightField::Grid grid;
    grid.columns = 9;
    grid.rows = 5;
    for (int n = 0; n < 45; ++n) grid.levels.push_back(static_cast<std::uint16_t>(n * 1000));
    const double odd[] = {0.0, -0.0, 0.5, 1e300, -1e300, kInfinity, -kInfinity, std::nan("")};
    for (const double water : {0.0, 1e5, kInfinity, -kInfinity, std::nan("")}) {
        grid.water = water;
        const HeightField field(grid);
        for (std::uint32_t seed = 0; seed < 4000; ++seed) {
            Rng rng(seed);
            const auto any = [&] { return odd[rng.below(8)]; };
            IntersectionList record(rng.coin() ? 0.0 : -kInfinity, kInfinity, rng.coin());
            field.intersect({{any(), any(), any()}, {any(), any(), any()}}, record);
            CHECK_NOTHROW(field.contains({any(), any(), any()}));
        }
    }
    CHECK(HeightField({}).bounds().empty());
    grid.levels.pop_back();
    CHECK(HeightField(grid).bounds().empty());
}
