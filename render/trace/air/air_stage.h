#pragma once

#include "render/trace/queue/segment_tile.h"

/// What lies between the rays of a tile and what they have met: the one place where a stretch of air is crossed.
/// Compiled once per instruction set.
namespace trace {

inline constexpr double kSkyDistance = 2e10;  ///< length of a ray that meets nothing, for fog and media

/// Whether a scene has anything that AirStage looks for.
inline bool has_air(const Context& context)
{
    const plan::CompiledScene& scene = context.scene;
    return scene.settings.quality >= 9 && (!scene.fogs.empty() || !scene.rainbows.empty());
}

class AirStage {
public:
    AirStage(Context& context, const SegmentTile& tile) : context_(context), tile_(tile) {}

    /// Fills ShadeScratch::air for the segments that something dims or brightens; which.
    HitMask run()
    {
        if (!has_air(context_)) return 0;
        HitMask hollow = 0;
        for (std::size_t k = 0; k < static_cast<std::size_t>(tile_.count()); ++k)
            if (tile_.interiors(k).all_hollow(context_.scene.interiors)) hollow |= HitMask{1} << k;
        for_each_hit(hollow, [&](std::size_t k) { context_.scratch.shade.air[k] = along(k); });
        return hollow;
    }

private:
    /// From what the ray has met to its origin (spec 6, 1.6).
    Air along(std::size_t k)
    {
        const csg::Ray ray = tile_.ray(k);
        const double length = has(tile_.found(), k) ? tile_.hits.t[k] : kSkyDistance;
        Air air;
        if (!context_.scene.rainbows.empty()) air.behind(rainbow_air(context_, ray, length));
        if (!context_.scene.fogs.empty()) air.behind(fog_air(context_, ray, length));
        return air;
    }

    Context& context_;
    const SegmentTile& tile_;
};

}  // namespace trace
