#pragma once

#include "render/kernel/context/context.h"

/// What shadow rays of a tile cross where solids tell one ray only so much (SceneTraits::restarts): behind each
/// crossing a new ray begins, as in POV-Ray. All of them take a step together, so that costly solids answer them
/// together.
namespace trace {

/// What a shadow ray crosses that begins anew behind each crossing.
struct RestartedRay {
    std::vector<csg::Hit> crossings;  ///< by distance from where it began
    csg::Shadow ending = csg::Shadow::Clear;
};

struct RestartedScratch {
    std::array<RestartedRay, csg::kTileRays> rays;
    csg::RayTile tile;
    csg::HitTile hits;
};

class RestartedRays {
public:
    /// No picture has so many crossings; a solid that is met again at every step would.
    static constexpr std::size_t kMost = 10000;

    explicit RestartedRays(const Context& context) : context_(context), kept_(context.scratch.shade.restarted()) {}

    /// first: what the ray meets first; null: that is not known.
    void add(std::size_t k, const csg::Ray& ray, double tolerance, double end, const Hit* first)
    {
        kept_.rays[k].crossings.clear();
        ways_[k] = {ray, tolerance, end, 0.0};
        active_ |= HitMask{1} << k;
        if (first != nullptr) advance(k, *first);
    }

    void run()
    {
        while (active_ != 0) {
            std::array<std::size_t, csg::kTileRays> lane;
            csg::RayTile& tile = kept_.tile;
            tile.count = 0;
            tile.common_origin = false;
            for_each_hit(active_, [&](std::size_t k) {
                const auto i = static_cast<std::size_t>(tile.count++);
                lane[i] = k;
                tile.set(i, ways_[k].ray, ways_[k].tolerance, ways_[k].end - ways_[k].gone);
            });
            context_.world.nearest(tile, bit(plan::RayKind::Shadow), context_.scratch.geometry, kept_.hits);
            for (int i = 0; i < tile.count; ++i) advance(lane[static_cast<std::size_t>(i)], kept_.hits.at(i));
        }
    }

private:
    struct Way {
        csg::Ray ray;
        double tolerance, end, gone;  ///< `end`: of the whole way
    };

    /// The ray goes on behind a hit, or has come to its end.
    void advance(std::size_t k, Hit hit)
    {
        RestartedRay& out = kept_.rays[k];
        Way& way = ways_[k];
        if (!hit.found()) return finish(k, out.crossings.empty() ? Shadow::Clear : Shadow::Filtered);
        if (context_.scene.geometry.surface_opaque[hit.surface] != 0) return finish(k, Shadow::Blocked);
        way.ray.origin = way.ray.at(hit.t);
        way.gone += hit.t;
        hit.t = way.gone;
        out.crossings.push_back(hit);
        if (out.crossings.size() == kMost) finish(k, Shadow::Filtered);
    }

    void finish(std::size_t k, Shadow ending)
    {
        kept_.rays[k].ending = ending;
        active_ &= ~(HitMask{1} << k);
    }

    const Context& context_;
    RestartedScratch& kept_;
    HitMask active_ = 0;
    std::array<Way, csg::kTileRays> ways_;
};

}  // namespace trace
