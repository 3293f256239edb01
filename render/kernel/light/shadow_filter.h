#pragma once

#include "render/kernel/context/context.h"

/// What a shadow ray leaves of light on its way (spec 3, section 13).
namespace trace {

class MediaShadows;
struct RestartedRay;

/// What fills the space that a shadow ray crosses.
struct ShadowAir {
    bool atmosphere = false;        ///< what fills the whole scene dims it
    MediaShadows* later = nullptr;  ///< receives stretches of media that have to be sampled; null: they are sampled
    std::size_t lane = 0;           ///< of the light that those dim
    /// Receives the distance of the last crossing; what fills the scene does not dim the rest of the way then. Null: it
    /// does.
    double* last_crossing = nullptr;
};

/// Colour of a light after everything between it and the point, which `interiors` hold (spec 3, section 13).
/// `tolerance`: of shadow rays from this point; first: the first
/// crossing from the point, where it is known and solids are such that the others have to be asked for one by one
/// (SceneTraits::restarts); known: what that has told already, which goes to Scratch::crossings.
glm::vec3 filtered_light(Context& context, const glm::dvec3& point, double tolerance, const InteriorList& interiors,
                         const light::Illumination& lit, glm::vec3 color, const ShadowAir& air = {},
                         const Hit* first = nullptr, RestartedRay* known = nullptr);

/// Crossings of a ray from a light, nearest first, as a ray to it over this distance has them: more than one.
void turn_all_round(Hit* crossings, std::size_t count, double distance);
inline void turn_round(Hit* crossings, std::size_t count, double distance)
{
    if (count > 1) return turn_all_round(crossings, count, distance);
    if (count == 1) crossings->t = distance - crossings->t;
}

/// The same as filtered_light() of lit.color where the crossings of surfaces that let light through are known, nearest
/// first from the point or from the light; these are turned round in place. filters: what surfaces leave of it,
/// by crossing, where they are nearest first from the point and that is known (light/surface_filters.h).
glm::vec3 shadow_transmittance(Context& context, const glm::dvec3& point, double tolerance,
                               const InteriorList& interiors, const light::Illumination& lit, bool from_light,
                               Hit* crossings, std::size_t count, const ShadowAir& air = {},
                               const glm::vec3* filters = nullptr);

/// Share of light that fog and media of the whole scene let pass between two distances along a shadow ray (spec
/// 6, 2.8): fog where it is inside of nothing solid, media also where it is, unless the stretch ends at the light.
glm::vec3 atmosphere_share(const Context& context, const RayState& ray, double from, double to, bool at_light,
                           const ShadowAir& air = {});

}  // namespace trace
