#include "render/kernel/light/surface_filter.h"
#include "render/kernel/light/restarted_rays.h"
#include "render/kernel/extinction/media_extinction.h"
#include "render/kernel/extinction/uneven_fog.h"
#include "render/kernel/interior/interior_fade.h"
#include "render/kernel/tile/nearly_zero.h"
#include "render/kernel/light/shadow_filter.h"

#include <algorithm>
#include <cmath>

/// Shadow rays through transparent things (spec 3, section 13).
namespace trace {
namespace {

/// A shadow ray as rays are that go on. Member by member: to make it whole would clear the list of interiors first.
struct ShadowState : RayState {
    ShadowState(const glm::dvec3& from, const glm::dvec3& toward, double nearest, const InteriorList& inside)
    {
        ray = {from, toward};
        start = nearest;
        kind = plan::RayKind::Shadow;
        interiors = inside;
    }
};

/// Light past crossings at their distances from the point, nearest first: color. before: the distance of the last one;
/// filters: as shadow_transmittance() has it.
void past_crossings(Context& context, RayState& ray, double tolerance, glm::vec3& color, const Hit* first,
                    const Hit* last, double& before, const ShadowAir& air, const glm::vec3* filters = nullptr)
{
    const plan::SceneTraits& traits = context.traits;
    for (const Hit* const begin = first; first != last; ++first) {
        const Hit& crossing = *first;
        if (crossing.t - before <= tolerance) continue;  // the next ray would not see it
        if (air.atmosphere) color *= atmosphere_share(context, ray, before, crossing.t, false, air);
        if (traits.media && !dark(color))
            color *= interior_media_share(context.scene, ray, before, crossing.t, air.later, air.lane);
        const plan::SurfaceTraits& surface = traits.surfaces[crossing.surface];
        color *= surface.steady_filter ? surface.filter
                 : surface.filters_together && filters != nullptr
                     ? filters[first - begin]
                     : surface_filter(context.scene, context.world, ray.ray.direction, crossing,
                                      hit_details(context, ray.ray, crossing), context.scratch.shade.shares);
        if (traits.fades || traits.media || air.atmosphere) {
            const std::uint32_t interior = context.scene.surfaces[crossing.surface].interior;
            const bool inside = interior != plan::kNone && ray.interiors.holds(interior);
            if (inside) color *= interior_fade(context.scene.interiors[interior], crossing.t - before, true);
            // Signed on purpose: light below zero never updates the list (spec 3, 13.2).
            if (interior != plan::kNone && !(color.x < kDark && color.y < kDark && color.z < kDark)) {
                if (inside) ray.interiors.remove_first(interior);
                else ray.interiors.append(interior);
            }
        }
        before = crossing.t;
    }
}

/// What a shadow ray crosses, found as POV-Ray does it: by a new ray behind each crossing. Solids that tell one ray
/// only so much
/// (`max_trace` of an isosurface) tell the next one more. first: what it meets first, if that is known.
Shadow one_by_one(const Context& context, csg::Ray ray, double tolerance, double end, const Hit* first,
                  std::vector<Hit>& out)
{
    out.clear();
    double gone = 0.0;
    while (out.size() < RestartedRays::kMost) {
        Hit hit = first != nullptr ? *first
                                   : context.world.nearest(ray, tolerance, end - gone, bit(plan::RayKind::Shadow),
                                                           context.scratch.geometry);
        first = nullptr;
        if (!hit.found()) break;
        if (context.scene.geometry.surface_opaque[hit.surface] != 0) return Shadow::Blocked;
        ray.origin = ray.at(hit.t);
        gone += hit.t;
        hit.t = gone;
        out.push_back(hit);
    }
    return out.empty() ? Shadow::Clear : Shadow::Filtered;
}

/// Whether the way inside of something dims light.
bool dims_inside(const plan::SceneTraits& traits, const InteriorList& interiors)
{
    for (std::size_t i = 0; i < interiors.size(); ++i)
        if (traits.dimming[interiors[i]] != 0) return true;
    return false;
}

/// What surfaces leave of a light that filter it alike everywhere, where nothing else dims it: past_crossings() without
/// a ray. False, with nothing done, if one of them does not, or what is inside of it, or one of `interiors`.
bool past_steady(const Context& context, const InteriorList& interiors, double tolerance, glm::vec3& color,
                 const Hit* first, const Hit* last, double& before)
{
    const plan::SceneTraits& traits = context.traits;
    if (dims_inside(traits, interiors)) return false;
    if (!std::all_of(first, last, [&](const Hit& hit) { return traits.surfaces[hit.surface].filters_alone; }))
        return false;
    for (; first != last; ++first) {
        if (first->t - before <= tolerance) continue;
        color *= traits.surfaces[first->surface].filter;
        before = first->t;
    }
    return true;
}

}  // namespace

glm::vec3 atmosphere_share(const Context& context, const RayState& ray, double from, double to, bool at_light,
                           const ShadowAir& air)
{
    const plan::CompiledScene& scene = context.scene;
    const bool hollow = ray.interiors.all_hollow(scene.interiors);
    glm::vec3 share(1);
    if (!hollow && at_light) return share;
    if (!scene.fogs.empty() && hollow) share = fog_share(context, {ray.ray.at(from), ray.ray.direction}, to - from);
    if (!scene.atmosphere.extinguishes) return share;
    return share * atmosphere_media_share(scene, ray.ray, from, to, air.later, air.lane);
}

glm::vec3 filtered_light(Context& context, const glm::dvec3& point, double tolerance, const InteriorList& interiors,
                         const light::Illumination& lit, glm::vec3 color, const ShadowAir& air, const Hit* first,
                         RestartedRay* known)
{
    auto& crossings = context.scratch.crossings;
    crossings.clear();  // callers look at them
    const double end = lit.distance - tolerance;
    if (end <= tolerance) return color;
    ++context.scratch.counts.shadow;
    ShadowState ray(point, lit.direction, tolerance, interiors);
    if (known != nullptr) crossings.swap(known->crossings);
    const Shadow met = known != nullptr            ? known->ending
                       : context.traits.restarts() ? one_by_one(context, ray.ray, tolerance, end, first, crossings)
                                                   : context.world.shadow_crossings(
                                                         ray.ray, tolerance, end, context.scratch.geometry, crossings);
    if (met == Shadow::Blocked) return glm::vec3(0.0f);
    double before = 0.0;
    if (met != Shadow::Clear)
        past_crossings(context, ray, tolerance, color, crossings.data(), crossings.data() + crossings.size(), before,
                       air);
    if (air.last_crossing != nullptr) *air.last_crossing = before;
    else if (air.atmosphere) color *= atmosphere_share(context, ray, before, lit.distance, true, air);
    return color;
}

void turn_all_round(Hit* crossings, std::size_t count, double distance)
{
    Hit* const end = crossings + count;
    std::reverse(crossings, end);
    // Those at one place keep the order that they have for every ray.
    for (Hit* same = crossings; same != end;) {
        Hit* next = std::find_if(same, end, [t = same->t](const Hit& h) { return h.t != t; });
        std::reverse(same, next);
        same = next;
    }
    for (Hit* h = crossings; h != end; ++h) h->t = distance - h->t;
}

glm::vec3 shadow_transmittance(Context& context, const glm::dvec3& point, double tolerance,
                               const InteriorList& interiors, const light::Illumination& lit, bool from_light,
                               Hit* crossings, std::size_t count, const ShadowAir& air, const glm::vec3* filters)
{
    Hit* const end = crossings + count;
    if (from_light) turn_round(crossings, count, lit.distance);
    glm::vec3 color = lit.color;
    double before = 0.0;
    if (!air.atmosphere && past_steady(context, interiors, tolerance, color, crossings, end, before)) {
        if (air.last_crossing != nullptr) *air.last_crossing = before;
        return color;
    }
    ShadowState ray(point, lit.direction, tolerance, interiors);
    past_crossings(context, ray, tolerance, color, crossings, end, before, air, filters);
    if (air.last_crossing != nullptr) *air.last_crossing = before;
    else if (air.atmosphere) color *= atmosphere_share(context, ray, before, lit.distance, true, air);
    return color;
}

}  // namespace trace
