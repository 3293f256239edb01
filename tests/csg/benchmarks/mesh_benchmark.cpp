#include "csg/mesh/mesh_query.h"
#include "csg/mesh/mesh_shape.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <ctime>

using namespace csg;

namespace {

/// A displaced sphere of 998,000 triangles.
MeshInput big_sphere()
{
    constexpr std::uint32_t kRings = 500, kAround = 1000;
    MeshInput input;
    const auto radius = [](double a, double b) {
        return 1.0 + 0.1 * std::sin(9.0 * a) * std::sin(7.0 * b) + 0.02 * std::sin(61.0 * a) * std::cos(53.0 * b);
    };
    for (std::uint32_t i = 0; i <= kRings; ++i)
        for (std::uint32_t j = 0; j < kAround; ++j) {
            const double a = 3.14159265358979 * i / kRings, b = 6.28318530717959 * j / kAround, r = radius(a, b);
            input.vertices.push_back({r * std::sin(a) * std::cos(b), r * std::cos(a), r * std::sin(a) * std::sin(b)});
        }
    const auto at = [](std::uint32_t i, std::uint32_t j) { return i * kAround + j % kAround; };
    for (std::uint32_t i = 0; i < kRings; ++i)
        for (std::uint32_t j = 0; j < kAround; ++j) {
            if (i > 0) input.faces.push_back({.vertex = {at(i, j), at(i, j + 1), at(i + 1, j)}});
            if (i + 1 < kRings) input.faces.push_back({.vertex = {at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)}});
        }
    return input;
}

/// Processor time, so that a busy machine matters less.
double since(std::clock_t start) { return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC; }

}  // namespace

TEST_CASE("a mesh of 998,000 triangles, rays of a camera one by one", "[!benchmark][csg][mesh]")
{
    const MeshInput input = big_sphere();
    const auto built = std::clock();
    const MeshShape shape(input);
    WARN("build " << since(built) << " s, "
                  << static_cast<double>(shape.bytes()) / static_cast<double>(shape.triangles())
                  << " bytes a triangle");
    double best = kInfinity;
    for (int repeat = 0; repeat < 5; ++repeat) {
        const auto start = std::clock();
        int hits = 0;
        for (int y = 0; y < 512; ++y)
            for (int x = 0; x < 512; ++x) {
                const Ray ray{{0, 0, -4}, glm::normalize(glm::dvec3((x - 256) / 800.0, (y - 256) / 800.0, 1))};
                double nearest = kInfinity;
                mesh_crossings(shape, ray, 0.0, kInfinity, [&](double t, std::uint32_t) { return nearest = t; });
                hits += nearest < kInfinity ? 1 : 0;
            }
        REQUIRE(hits > 100000);
        best = std::min(best, since(start) / (512 * 512) * 1e9);
    }
    WARN(best << " ns a ray");
}
