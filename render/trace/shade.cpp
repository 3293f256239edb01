#include "render/trace/shade.h"

#include "render/trace/tile_shader.h"

#include <algorithm>

namespace trace {
namespace {

/// starts: interiors of camera rays that do not share `camera`'s, or null.
void shade(Context& context, const RayTile& rays, const HitTile& hits, const RayState& camera, const InteriorList* starts, const WaitingRay* waiting)
{
    auto& stack = context.scratch.shade.lights;
    Wave& wave = context.scratch.shade.wave;
    const std::size_t base = stack.size(), lights = context.scene.lights.lights.size(), first = wave.rays.size();
    TileShader tile(context, rays, hits, camera, starts, waiting);
    if (tile.prepare()) {
        stack.resize(base + lights * static_cast<std::size_t>(rays.count));
        tile.use_samples(base);
    }
    for (std::size_t i = 0; i < lights; ++i) tile.light(i);
    tile.finish();
    for (int i = 0; i < rays.count; ++i) tile.color(i);
    stack.resize(base);
    wave.end_tile(first);
}

/// Hits of waiting rays, which are of one kind or of kinds that see the same: as a beam if they come from one point, one by one otherwise.
void trace_waiting(Context& context, const WaitingRay* waiting, int count)
{
    ShadeScratch& scratch = context.scratch.shade;
    RayTile& rays = scratch.onward_rays;
    HitTile& hits = scratch.onward_hits;
    rays.count = count;
    const std::uint8_t kind = bit(waiting[0].state.kind);
    glm::dvec3 origin;
    // What such solids tell a ray depends on where it began.
    rays.common_origin = !scratch.traits.beside && !context.scene.geometry.faithful && from_one_point(waiting, count, origin);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const csg::Ray& ray = waiting[i].state.ray;
        if (rays.common_origin)
            rays.set(i, {origin, ray.direction}, waiting[i].reach + waiting[i].state.start, csg::kInfinity);
        else
            rays.set(i, ray, waiting[i].state.start, csg::kInfinity);
    }
    context.world.nearest(rays, kind, context.scratch.geometry, hits);
    if (!rays.common_origin) return;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        rays.set(i, waiting[i].state.ray, waiting[i].state.start, csg::kInfinity);
        hits.t[i] -= waiting[i].reach;
    }
}

/// Makes one of the last batches while they are small: few rays make a poor beam.
void join_small_batches(const Context& context, Wave& wave)
{
    constexpr std::size_t kSmall = 16;
    const auto kind = [&](std::size_t batch) { return bit(wave.rays[wave.batches[batch]].state.kind); };
    for (std::size_t last = wave.batches.size() - 1; last > 0; --last) {
        if (wave.rays.size() - wave.batches[last] >= kSmall || wave.rays.size() - wave.batches[last - 1] > kTileRays) return;
        const std::uint8_t both = kind(last) | kind(last - 1);
        if (kind(last) != kind(last - 1) && !context.world.seen_by_all(both)) return;
        wave.batches.pop_back();
    }
}

/// The batch of rays that waits last: traced and shaded, up to a tile of them.
void shade_waiting(Context& context, const RayState& camera)
{
    ShadeScratch& scratch = context.scratch.shade;
    Wave& wave = scratch.wave;
    join_small_batches(context, wave);
    const std::size_t begin = wave.batches.back();
    const std::size_t count = std::min<std::size_t>(wave.rays.size() - begin, kTileRays), first = wave.rays.size() - count;
    std::copy_n(wave.rays.begin() + static_cast<std::ptrdiff_t>(first), count, scratch.waiting.begin());
    wave.rays.resize(first);
    if (first == begin) wave.batches.pop_back();
    trace_waiting(context, scratch.waiting.data(), static_cast<int>(count));
    shade(context, scratch.onward_rays, scratch.onward_hits, camera, nullptr, scratch.waiting.data());
}

}  // namespace

void shade_tile(const plan::CompiledScene& scene, const RayTile& rays, const HitTile& hits, const InteriorList* starts, scene::Color* out,
                Scratch& scratch)
{
    Context context{scene, scene.world(), scratch};
    if (scratch.shade.traits.surfaces.empty()) scratch.shade.traits = scene_traits(scene);
    RayState camera;
    for (const std::uint32_t interior : scene.camera_interiors) camera.interiors.append(interior);
    Wave& wave = scratch.shade.wave;
    wave.clear(static_cast<std::size_t>(rays.count));
    shade(context, rays, hits, camera, starts, nullptr);
    while (!wave.batches.empty()) shade_waiting(context, camera);
    collect(context);
    std::copy_n(wave.colors.begin(), rays.count, out);
}

}  // namespace trace
