#include "bench/embree/rays.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>

using namespace embree_bench;

namespace {

constexpr int kWidth = 640, kHeight = 480;
const glm::dvec3 kLamp{4.0, 7.0, -5.0};
// A shadow ray ends so far before what it comes from; single precision resolves 1e-6 here.
constexpr double kSkin = 1e-3;

/// Balls spread evenly in a cube (a lattice of irrational steps), as bench/large.py has them.
Scene balls(std::uint32_t n)
{
    Scene scene{.name = fmt::format("{} balls", n), .balls = {}, .corners = {}, .faces = {}};
    const double radius = 0.75 / std::cbrt(n);
    for (std::uint32_t i = 1; i <= n; ++i) {
        const auto at = [i](double step) { return 2.0 * std::fmod(i * step, 1.0) - 1.0; };
        scene.balls.push_back({{at(0.8191725134), at(0.6710436067), at(0.5497004779)}, radius});
    }
    return scene;
}

/// Hills on a square grid of about n triangles.
Scene mesh(std::uint32_t n)
{
    Scene scene;
    const auto side = static_cast<std::uint32_t>(std::lround(std::sqrt(n / 2.0)));
    for (std::uint32_t i = 0; i <= side; ++i)
        for (std::uint32_t k = 0; k <= side; ++k) {
            const double x = 2.0 * i / side - 1.0, z = 2.0 * k / side - 1.0;
            const double hill = std::sin(5.0 * x) * std::cos(4.0 * z);
            const double ripple = std::sin(40.0 * x + 3.0 * std::sin(30.0 * z));
            scene.corners.push_back({x, 0.2 * hill + 0.01 * ripple, z});
        }
    for (std::uint32_t i = 0; i < side; ++i)
        for (std::uint32_t k = 0; k < side; ++k) {
            const std::uint32_t a = i * (side + 1) + k, b = a + side + 1;
            scene.faces.push_back({a, a + 1, b});
            scene.faces.push_back({a + 1, b + 1, b});
        }
    scene.name = fmt::format("{} triangles", scene.faces.size());
    return scene;
}

/// The rays of a picture, 8x8 pixels a tile: the camera of bench/large.py.
std::vector<csg::RayTile> camera_rays()
{
    const glm::dvec3 eye{1.6, 1.9, -2.6}, ahead = glm::normalize(glm::dvec3(0.0, -0.05, 0.0) - eye);
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), ahead)), up = glm::cross(ahead, right);
    const double half = std::tan(0.5 * 45.0 * std::acos(-1.0) / 180.0), pixel = 2.0 * half / kWidth;
    std::vector<csg::RayTile> tiles;
    for (int top = 0; top < kHeight; top += csg::kTileSide)
        for (int left = 0; left < kWidth; left += csg::kTileSide) {
            csg::RayTile& tile = tiles.emplace_back();
            tile.count = csg::kTileRays;
            tile.common_origin = true;
            for (int i = 0; i < csg::kTileRays; ++i) {
                const double x = left + i % csg::kTileSide + 0.5 - kWidth / 2;
                const double y = kHeight / 2 - (top + i / csg::kTileSide + 0.5);
                const glm::dvec3 direction = glm::normalize(ahead + pixel * (x * right + y * up));
                tile.set(static_cast<std::size_t>(i), {eye, direction}, 1e-4, 1e30);
            }
        }
    return tiles;
}

/// From the lamp to every hit, the hits of a tile together.
std::vector<csg::RayTile> shadow_rays(const std::vector<csg::RayTile>& camera, const Built& ours)
{
    std::vector<csg::RayTile> tiles;
    for (const csg::RayTile& rays : camera) {
        const csg::HitTile hits = ours.hits(rays);
        csg::RayTile tile{};
        tile.common_origin = true;
        for (int i = 0; i < rays.count; ++i) {
            const csg::Hit hit = hits.at(i);
            if (!hit.found()) continue;
            const glm::dvec3 away = rays.ray(i).at(hit.t) - kLamp;
            const auto place = static_cast<std::size_t>(tile.count++);
            tile.set(place, {kLamp, glm::normalize(away)}, kSkin, glm::length(away) - kSkin);
        }
        if (tile.count > 0) tiles.push_back(tile);
    }
    return tiles;
}

std::uint64_t count(const std::vector<csg::RayTile>& tiles)
{
    std::uint64_t sum = 0;
    for (const csg::RayTile& tile : tiles) sum += static_cast<std::uint64_t>(tile.count);
    return sum;
}

/// All methods over the same rays in turn, the least of the runs; a line of CSV each.
void measure(const Scene& scene, const char* kind, Asked asked, const std::vector<csg::RayTile>& rays,
             const std::vector<Method>& methods, int runs)
{
    std::vector<double> least(methods.size(), numbers::kInfinity);
    std::vector<std::uint64_t> found(methods.size());
    for (int run = 0; run < runs; ++run)
        for (std::size_t m = 0; m < methods.size(); ++m) {
            const double began = now();
            found[m] = methods[m].ask(asked, rays);
            least[m] = std::min(least[m], now() - began);
        }
    const auto many = static_cast<double>(count(rays));
    for (std::size_t m = 0; m < methods.size(); ++m)
        fmt::print("{},{},{},{},{:.1f},{:.0f},{}\n", scene.name, kind, methods[m].program, methods[m].name,
                   least[m] / many * 1e9, many, found[m]);
}

}  // namespace

// embree_rays RUNS BALLS TRIANGLES
int main(int argc, char** argv)
try {
    const auto number = [&](int k, std::uint32_t usual) {
        return argc > k ? static_cast<std::uint32_t>(std::strtoul(argv[k], nullptr, 10)) : usual;
    };
    const int runs = static_cast<int>(number(1, 5));
    fmt::print("scene,rays,program,method,ns_a_ray,count,hits\n");
    const std::vector<csg::RayTile> camera = camera_rays();
    for (const Scene& scene : {balls(number(2, 100'000)), mesh(number(3, 1'000'000))}) {
        const Built ours = build_ours(scene), embree = build_embree(scene);
        const std::size_t parts = scene.balls.size() + scene.faces.size();
        const auto tell_build = [&](const char* program, const Built& built) {
            const double each = built.build_s * 1e9 / static_cast<double>(parts);
            fmt::print("{},build,{},,{:.1f},{},\n", scene.name, program, each, parts);
        };
        tell_build("Whittle", ours);
        tell_build("Embree", embree);
        std::vector<Method> methods = ours.methods;
        methods.insert(methods.end(), embree.methods.begin(), embree.methods.end());
        measure(scene, "camera", Asked::Nearest, camera, methods, runs);
        measure(scene, "shadow", Asked::Any, shadow_rays(camera, ours), methods, runs);
    }
    return 0;
} catch (const std::exception& error) {
    fmt::print(stderr, "embree_rays: {}\n", error.what());
    return 1;
}
