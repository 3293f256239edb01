#pragma once

#include "render/plan/compiled_scene.h"
#include "render/kernel/tile/hit_mask.h"

#include <algorithm>

namespace trace {

/// Whether photons stay on a surface, and are seen there.
inline bool collects(const plan::CompiledScene& scene, csg::SurfaceId surface)
{
    return scene.photons->surfaces[scene.surfaces[surface].photons].collect;
}

/// Targets that stop a light's shadow rays, as photons bring what passes them (spec 6, 3.11).
struct PhotonShadow {
    const plan::CompiledScene* scene = nullptr;       ///< null: no photons are on any surface
    plan::Consent refraction = plan::Consent::Unset;  ///< of the light at hand
    HitMask lit = 0;                                  ///< hits of the tile at hand that photons stay on

    /// The light at hand, by its number.
    void of_light(std::size_t light)
    {
        if (scene != nullptr) refraction = scene->photons->lights[light].refraction;
    }

    /// Whether a shadow ray of hit k is stopped by one of its crossings.
    bool stops(std::size_t k, const csg::Hit* crossings, std::size_t count) const
    {
        if (scene == nullptr || !has(lit, k)) return false;
        return std::any_of(crossings, crossings + count, [this](const csg::Hit& crossing) {
            const plan::PhotonSurface& met = scene->photons->surfaces[scene->surfaces[crossing.surface].photons];
            return met.target != plan::PhotonSurface::kNoTarget && plan::agree(met.refraction, refraction);
        });
    }
};

}  // namespace trace
