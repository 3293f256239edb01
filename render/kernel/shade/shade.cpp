#include "render/kernel/context/shade_tile.h"

#include "render/kernel/air/air_stage.h"
#include "render/kernel/indirect/indirect_stage.h"
#include "render/kernel/light/light_stage.h"
#include "render/kernel/air/sky.h"
#include "render/kernel/record/recorder.h"
#include "render/kernel/surface/surface_stage.h"

#include <algorithm>
#include <array>

namespace trace {
namespace {

/// Traced segments become colours, or nodes and rays of the queue. starts: interiors of camera rays that do not share
/// `camera`'s, or null.
void shade(Context& context, const RayTile& rays, const HitTile& hits, const RayState& camera,
           const InteriorList* starts, const QueuedRay* queued)
{
    RayQueue& queue = context.scratch.shade.queue;
    queue.begin_tile();
    const SegmentTile tile(context, rays, hits, camera, starts, queued);
    DirectBatch batch(context, rays.count);
    const HitMask dimmed = AirStage(context, tile).run();
    SurfaceStage(context, tile, batch, dimmed).run();
    LightStage(context, tile, batch).run();
    IndirectStage(context, tile, batch).run();
    batch.finish();
    mix_maps(context);
    batch.close_nodes(queue);
    const HitMask missed = first_hits(rays.count) & ~tile.found();
    const auto put = [&](std::size_t k, const scene::Color& color) {
        queue.colors[tile.slot(k)] = has(dimmed, k) ? context.scratch.shade.air[k](color) : color;
    };
    if (missed != 0) {
        std::array<scene::Color, kTileRays> sky;
        sky_colors(context, tile, missed, sky.data());
        tell<&Recorder::sky>(context.scratch.shade, missed, sky.data());
        for_each_hit(missed, [&](std::size_t k) { put(k, sky[k]); });
    }
    for_each_hit(batch.all_alone(), [&](std::size_t k) { put(k, scene::Color::of(batch.sum(k))); });
    tell<&Recorder::tile>(context.scratch.shade, tile, batch.depths(), dimmed, batch.all_alone());
    queue.end_tile();
}

/// Finds the hits of queued rays, which are of one kind or of kinds that see the same objects. Rays off a flat mirror
/// could go as a beam from the mirrored eye; that saves nothing, and the hits would lose the digits that separate rays
/// have, which patterns with edges show.
void intersect(Context& context, const QueuedRay* queued, int count)
{
    ShadeScratch& scratch = context.scratch.shade;
    RayTile& rays = scratch.segments.rays;
    rays.count = count;
    rays.common_origin = false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        rays.set(i, queued[i].state.ray, queued[i].state.start, numbers::kInfinity);
    context.world.nearest(rays, bit(queued[0].state.kind), context.scratch.geometry, scratch.segments.hits);
}

/// Traces and shades the batch of rays that has been queued last, up to a tile of them.
void shade_queued(Context& context, const RayState& camera)
{
    ShadeScratch& scratch = context.scratch.shade;
    RayQueue& queue = scratch.queue;
    const auto alike = [&](plan::RayKind a, plan::RayKind b) {
        return a == b || context.world.seen_by_all(bit(a) | bit(b));
    };
    const std::size_t count =
        queue.take(context.scene.options.grain_stream ? 1 : kTileRays, scratch.segments.queued.data(), alike);
    intersect(context, scratch.segments.queued.data(), static_cast<int>(count));
    shade(context, scratch.segments.rays, scratch.segments.hits, camera, nullptr, scratch.segments.queued.data());
}

}  // namespace

// Never inlined: tests/lean counts instructions by its name.
[[gnu::noinline]] void shade_tile(Context& context, const RayTile& rays, const HitTile& hits, const RayState& first,
                                  const InteriorList* starts, scene::Color* out)
{
    ShadeScratch& scratch = context.scratch.shade;
    RayQueue& queue = scratch.queue;
    queue.start(static_cast<std::size_t>(rays.count));
    shade(context, rays, hits, first, starts, nullptr);
    for (queue.fold(); !queue.empty(); queue.fold()) shade_queued(context, first);
    std::copy_n(queue.colors.begin(), rays.count, out);
}

}  // namespace trace
