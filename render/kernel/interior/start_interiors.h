#pragma once

#include "render/plan/compiled_scene.h"
#include "render/kernel/tile/ray_state.h"

#include <array>

namespace trace {

/// What the camera rays of a tile start inside of, where that may differ from ray to ray (spec 2, 4.11); free where it
/// may not.
class StartInteriors {
public:
    explicit StartInteriors(const plan::CompiledScene& scene) : scene_(scene), world_(scene.world()) {}

    /// By ray of the tile; null: all start inside of CompiledScene::camera_interiors.
    const InteriorList* lists() const { return asked() ? lists_.data() : nullptr; }

    void find(std::size_t ray, const glm::dvec3& origin)
    {
        if (!asked()) return;
        InteriorList& list = lists_[ray];
        list = {};
        for (const plan::StartHolder& holder : scene_.start_holders)
            if (plan::within(holder.only, origin) && world_.item_holds_start(holder.item, origin))
                list.append(holder.interior);
    }

    /// Of one of a blurred position's rays, in order. `clouded`: fog was missing for one of them; for those after it it
    /// is too (InteriorList::cloud).
    void find(std::size_t ray, const glm::dvec3& origin, bool& clouded)
    {
        if (!asked()) return;
        find(ray, origin);
        if (clouded) lists_[ray].cloud();
        clouded = !lists_[ray].all_hollow(scene_.interiors);
    }

    /// False: find() does nothing.
    bool asked() const { return !scene_.start_holders.empty(); }

private:
    const plan::CompiledScene& scene_;
    csg::World world_;
    std::array<InteriorList, kTileRays> lists_;
};

}  // namespace trace
