#include "render/kernel/media/media_photons.h"

#include "render/kernel/gather/indirect_light.h"

#include <cmath>
#include <numbers>

namespace trace {

void media_photons(const Context& context, const texture::Points& points, HitMask which,
                   const std::array<glm::dvec3, csg::kTileRays>& directions,
                   const std::array<const MediaMix*, csg::kTileRays>& mixes, TileColors& light)
{
    const PhotonMap& map = context.indirect->media_photons;
    ShadeScratch& scratch = context.scratch.shade;
    NearPhotons& near = scratch.photons.near;
    near.forget();  // pictures do not depend on the order of batches
    scratch.photons.wide.forget();
    glm::dvec3 low(numbers::kInfinity), high(-numbers::kInfinity);
    for_each_hit(which, [&](std::size_t k) {
        low = glm::min(low, points.at(k));
        high = glm::max(high, points.at(k));
    });
    const PhotonReach reach = map.reach(low, high);
    for_each_hit(which, [&](std::size_t k) {
        map.gather(points.at(k), nullptr, reach, scratch.photons.wide, near);
        glm::vec3 sum(0);
        const bool even = mixes[k]->one_kind && mixes[k]->members[0]->phase == plan::Media::Phase::Isotropic;
        for (const NearPhotons::Near& of : near.found) {
            const PhotonRay& photon = map.ray(of.photon);
            const double turned = even ? 1.0 : mixes[k]->phase(glm::dot(directions[k], glm::dvec3(photon.back)));
            sum += static_cast<float>(turned) * photon.flux;
        }
        const double volume = 4.0 / 3.0 * std::numbers::pi * near.radius2 * std::sqrt(near.radius2);
        light.set(k, near.found.empty() ? glm::vec3(0) : sum / static_cast<float>(volume));
    });
}

bool has_media_photons(const Context& context)
{
    return context.indirect != nullptr && !context.indirect->media_photons.empty();
}

bool has_surface_photons(const Context& context)
{
    return context.indirect != nullptr && !context.indirect->photons.empty();
}

}  // namespace trace
