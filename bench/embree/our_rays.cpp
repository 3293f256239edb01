#include "bench/embree/rays.h"
#include "csg/tree/program.h"
#include "csg/world/world.h"
#include "csg/items/world_data.h"

#include <memory>

namespace embree_bench {

namespace {

constexpr std::uint8_t kAnyKind = 1;

csg::WorldData world_of(const Scene& scene)
{
    csg::WorldData data;
    data.surface_opaque.push_back(1);
    for (const Ball& ball : scene.balls)
        data.add_solid(data.store.add(csg::Sphere{ball.center, ball.radius}, 0), false, 0, 0xff);
    if (!scene.faces.empty()) {
        csg::MeshInput input;
        input.vertices = scene.corners;
        input.faces.reserve(scene.faces.size());
        for (const auto& face : scene.faces) input.faces.push_back({.vertex = face});
        csg::Mesh mesh;
        mesh.shape = std::make_shared<const csg::MeshShape>(input);
        mesh.surfaces = {0};
        data.add_solid(data.store.add(mesh, 0), false, 0, 0xff);
    }
    data.finish();
    return data;
}

/// A world and what a thread needs to ask it.
struct Asking {
    csg::WorldData data;
    csg::World world{data};
    csg::Scratch scratch;

    explicit Asking(const Scene& scene) : data(world_of(scene)) {}

    std::uint64_t tiles(Asked asked, const std::vector<csg::RayTile>& rays)
    {
        std::uint64_t found = 0;
        csg::HitTile hits;
        std::array<csg::Shadow, csg::kTileRays> shadows{};
        for (const csg::RayTile& tile : rays) {
            const auto count = static_cast<std::size_t>(tile.count);
            if (asked == Asked::Nearest) {
                world.nearest(tile, kAnyKind, scratch, hits);
                for (std::size_t k = 0; k < count; ++k) found += hits.surface[k] != csg::kNoSurface;
            } else {
                world.shadow(tile, scratch, shadows.data());
                for (std::size_t k = 0; k < count; ++k) found += shadows[k] == csg::Shadow::Blocked;
            }
        }
        return found;
    }

    std::uint64_t singly(Asked asked, const std::vector<csg::RayTile>& rays)
    {
        std::uint64_t found = 0;
        for (const csg::RayTile& tile : rays)
            for (int i = 0; i < tile.count; ++i) {
                const auto k = static_cast<std::size_t>(i);
                const csg::Ray ray = tile.ray(i);
                if (asked == Asked::Nearest)
                    found += world.nearest(ray, tile.t_min[k], tile.t_max[k], kAnyKind, scratch).found();
                else found += world.shadow(ray, tile.t_min[k], tile.t_max[k], scratch) == csg::Shadow::Blocked;
            }
        return found;
    }

    csg::HitTile hits(const csg::RayTile& tile)
    {
        csg::HitTile out;
        world.nearest(tile, kAnyKind, scratch, out);
        return out;
    }
};

}  // namespace

Built build_ours(const Scene& scene)
{
    const double began = now();
    const auto asking = std::make_shared<Asking>(scene);
    Built built{.build_s = now() - began, .methods = {}, .hits = {}};
    built.methods.push_back(
        {"Whittle", "tiles of 64", [asking](Asked asked, const auto& rays) { return asking->tiles(asked, rays); }});
    built.methods.push_back(
        {"Whittle", "single", [asking](Asked asked, const auto& rays) { return asking->singly(asked, rays); }});
    built.hits = [asking](const csg::RayTile& tile) { return asking->hits(tile); };
    return built;
}

}  // namespace embree_bench
