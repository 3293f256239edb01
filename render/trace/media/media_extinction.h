#pragma once

#include "render/trace/media/media_mix.h"

#include <vector>

namespace trace {

/// Share of light that the media let through between two distances along a shadow ray (spec 6, 2.7 and 2.8).
glm::vec3 media_share(const plan::CompiledScene& scene, const MediaMix& mix, const csg::Ray& ray, double from,
                      double to);

/// Stretches of shadow rays whose densities are looked up together, when all rays of a tile have been followed.
class MediaShadows {
public:
    void clear() { stretches_.clear(), mix_count_ = 0; }
    bool empty() const { return stretches_.empty(); }

    /// lane: whose light is dimmed.
    void add(const MediaMix& mix, const csg::Ray& ray, double from, double to, std::size_t lane);

    /// Calls give(lane, share) for every stretch, in any order.
    template <class Give>
    void run(const plan::CompiledScene& scene, Give&& give)
    {
        find_depths(scene);
        for (const Stretch& stretch : stretches_) give(std::size_t{stretch.lane}, share_of(stretch.depth));
        clear();
    }

private:
    struct Stretch {
        csg::Ray ray;
        double from, to;
        std::uint32_t mix;
        std::uint8_t lane;
        glm::vec3 depth;
    };
    void find_depths(const plan::CompiledScene& scene);
    static glm::vec3 share_of(const glm::vec3& depth);

    std::vector<Stretch> stretches_;
    std::vector<MediaMix> mixes_;
    std::size_t mix_count_ = 0;
};

/// The same for media of what a shadow ray is inside of; all light passes where it is inside of something solid.
/// later: receives stretches that have to be sampled, as those of `lane`; their share is 1 for now. Null: they are
/// sampled at once.
glm::vec3 interior_media_share(const plan::CompiledScene& scene, const RayState& ray, double from, double to,
                               MediaShadows* later, std::size_t lane);

/// Of media of the whole scene.
glm::vec3 atmosphere_media_share(const plan::CompiledScene& scene, const csg::Ray& ray, double from, double to,
                                 MediaShadows* later, std::size_t lane);

}  // namespace trace
