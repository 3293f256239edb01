#pragma once

#include "render/kernel/extinction/media_mix.h"
#include "render/kernel/tile/row_page.h"

#include <vector>

namespace trace {

/// Share of light that the media let through between two distances along a shadow ray (spec 6, 2.7 and 2.8).
glm::vec3 media_share(const plan::CompiledScene& scene, const MediaMix& mix, const csg::Ray& ray, double from,
                      double to);

/// What has been found where the shadow rays of a tile start, by lane.
struct MediaStarts {
    const TileColors& extinction;
    std::array<const MediaMix*, csg::kTileRays> mixes;
};

/// Stretches of shadow rays whose densities are looked up together, when all rays of a tile have been followed.
class MediaShadows {
public:
    void clear() { stretches_.clear(), mix_count_ = 0, inside_known_ = even_known_ = false; }
    bool empty() const { return stretches_.empty(); }
    std::size_t size() const { return stretches_.size(); }
    /// Until further notice rays start where this has been found; null: nothing has.
    void start_at(const MediaStarts* starts) { starts_ = starts; }

    /// lane: whose light is dimmed.
    void add(const MediaMix& mix, const csg::Ray& ray, double from, double to, std::size_t lane);
    /// The same of the media of what the ray is inside of. add_again: if they are the last ones that were added so.
    void add(const InteriorList& inside, const MediaMix& mix, const csg::Ray& ray, double from, double to,
             std::size_t lane);
    bool add_again(const InteriorList& inside, const csg::Ray& ray, double from, double to, std::size_t lane);

    /// Extinction of media that are alike everywhere, if these were asked for last; null: they were not.
    const glm::vec3* even(const InteriorList& inside) const
    {
        return even_known_ && even_inside_ == inside ? &even_extinction_ : nullptr;
    }
    void keep_even(const InteriorList& inside, const glm::vec3& extinction)
    {
        even_inside_ = inside;
        even_extinction_ = extinction;
        even_known_ = true;
    }

    /// Calls give(lane, share) for every stretch, in any order.
    template <class Give>
    void run(const plan::CompiledScene& scene, Give&& give)
    {
        find_depths(scene);
        find_shares();
        for (const Stretch& stretch : stretches_) give(std::size_t{stretch.lane}, stretch.share);
        clear();
    }

private:
    struct Stretch {
        csg::Ray ray;
        double from, to;
        std::uint32_t mix;
        std::uint8_t lane;
        bool start_known = false;
        glm::vec3 start{0}, depth{0};  ///< extinction where it begins, if that is known; optical depth
        glm::vec3 share{1};            ///< of light that it lets through
    };
    void put(std::uint32_t mix, const csg::Ray& ray, double from, double to, std::size_t lane);
    void find_depths(const plan::CompiledScene& scene);
    void find_shares();

    std::vector<Stretch> stretches_;
    std::vector<float> exponents_;
    std::vector<MediaMix> mixes_;
    std::size_t mix_count_ = 0;
    const MediaStarts* starts_ = nullptr;
    InteriorList inside_;  ///< of the last ones that were added with such a list
    InteriorList even_inside_;
    glm::vec3 even_extinction_{0};
    std::uint32_t inside_mix_ = 0;
    bool inside_known_ = false, even_known_ = false;
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
