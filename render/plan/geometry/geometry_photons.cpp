#include "render/plan/geometry/extent.h"
#include "render/plan/geometry/geometry.h"

#include <algorithm>

// How photons find objects (spec 6, 3.1).
namespace plan {

/// What the object's parents say goes before what it says itself.
void GeometryCompiler::hand_down_photons(const scene::Object& object, Inherited& own)
{
    if (sharing_ != nullptr) sharing_->fails = true;  // copies may be given other flags from above
    const scene::PhotonFlags& flags = *object.details->photons;
    if (!(own.photon_density > 0.0)) own.photon_density = flags.target.value_or(0.0);
    PhotonSurface& to = own.photons;
    if (to.reflection == Consent::Unset) to.reflection = consent(flags.reflection);
    if (to.refraction == Consent::Unset) to.refraction = consent(flags.refraction);
    to.pass_through |= flags.pass_through;
    to.collect &= flags.collect;
}

/// An object that is one for POV-Ray becomes a target where photons are to be shot at it and it is not part of one.
void GeometryCompiler::aim_photons(const scene::Object& object, Inherited& own)
{
    if (!photons_ || clipping_ || sharing_ != nullptr || !(own.photon_density > 0.0) || is_light(object) ||
        own.photons.target != PhotonSurface::kNoTarget)
        return;
    const csg::Aabb box = placed_extent(object, own);
    own.photons.target = static_cast<std::uint32_t>(photons_->targets.size());
    photons_->targets.push_back({0.5 * (box.lower + box.upper), 0.5 * glm::length(box.upper - box.lower),
                                 own.photon_density, own.photons.reflection, own.photons.refraction,
                                 own.photons.collect, own.global_lights});
}

std::uint32_t GeometryCompiler::photon_surface(const Inherited& own)
{
    if (!photons_) return 0;
    std::vector<PhotonSurface>& known = photons_->surfaces;
    const auto same = std::find(known.begin(), known.end(), own.photons);
    if (same == known.end()) {
        known.push_back(own.photons);
        return static_cast<std::uint32_t>(known.size() - 1);
    }
    return static_cast<std::uint32_t>(same - known.begin());
}

}  // namespace plan
