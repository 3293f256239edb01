#pragma once

#include "render/plan/compiled_scene.h"
#include "render/scene/base/color.h"
#include "render/texture/shown.h"
#include "render/kernel/context/scratch.h"
#include "render/kernel/tile/geometry.h"
#include "render/kernel/tile/ray_state.h"

/// What every stage of shading is handed: the scene, its thread's scratch, and one hit (docs/shading.md).
namespace trace {

struct IndirectLight;
namespace radiosity {
struct BounceRules;
struct Filling;
}  // namespace radiosity

/// Everything shading reads and writes besides the ray.
struct Context {
    Context(const plan::CompiledScene& of, Scratch& own, const IndirectLight* light)
        : scene(of), traits(of.traits), world(of.world()), scratch(own), indirect(light), lights(of.lights),
          max_trace_level(of.settings.max_trace_level), adc_bailout(of.settings.adc_bailout)
    {}
    /// The same with another scratch, for work in the midst of a tile.
    Context(const Context& outer, Scratch& own)
        : scene(outer.scene), traits(outer.traits), world(outer.world), scratch(own), indirect(outer.indirect),
          lights(outer.lights), max_trace_level(outer.max_trace_level), adc_bailout(outer.adc_bailout),
          bounce(outer.bounce), below(outer.below), filling(outer.filling)
    {}
    /// A ray goes into what has this interior, or out of it.
    void cross(const plan::Interior& interior) const
    {
        if (traits.interior_media) scratch.shade.in_media |= !interior.media.empty();
    }
    /// For rays that gather light from within shading, by the rules of the bounce that they start at.
    Context gathering(const radiosity::BounceRules& rules) const;

    const plan::CompiledScene& scene;
    const plan::SceneTraits& traits;
    csg::World world;
    Scratch& scratch;
    const IndirectLight* indirect;  ///< what the passes before the picture have found; null: nothing
    const light::LightSet& lights;  ///< that these rays see
    int max_trace_level;
    double adc_bailout;
    int bounce = 0;                         ///< of light that is gathered: 0 for what the camera sees (spec 6, 4.1)
    int below = 0;                          ///< surfaces below which the rays have come unscattered (spec 6, 5.2)
    radiosity::Filling* filling = nullptr;  ///< a pass of radiosity: what it finds; null: in the picture

private:
    Context(const Context& outer, const radiosity::BounceRules& rules);
};

/// Whether a ray at this level and of this weight is traced.
inline bool worth_tracing(const Context& context, int level, float weight)
{
    return level < context.max_trace_level && !(static_cast<double>(weight) < context.adc_bailout);
}

/// Point, normal and what else the surface's textures ask for.
inline HitDetails hit_details(const Context& context, const csg::Ray& ray, const Hit& hit)
{
    return context.world.details(ray, hit, context.traits.surfaces[hit.surface].needs_uv);
}

/// Where a ray met a surface: all that the rays that go on from there depend on.
struct HitPlace {
    const RayState& state;
    const Hit& met;
    const plan::Surface& surface;
    glm::dvec3 point;
    glm::dvec3 normal;  ///< N0: raw, unit, faces the viewer
    int level;          ///< levels in use including this ray's
    bool from_inside;   ///< the normal had to be turned
};

/// A hit whose textures are evaluated. Built in place, member by member: a copy of what was just written in smaller
/// pieces would stall on store forwarding.
struct HitContext : HitPlace {
    HitContext(const RayState& of, const Hit& at, const plan::Surface& on, const glm::dvec3& p, const glm::dvec3& n,
               int in_use, bool inside, std::size_t k)
        : HitPlace{of, at, on, p, n, in_use, inside}, lane(k)
    {}
    HitContext(const HitPlace& at, std::size_t k) : HitPlace(at), lane(k) {}

    /// As patterns see it.
    void surround(const glm::dvec3& p, const glm::dvec2& uv)
    {
        around.point = p;
        around.normal = normal;
        around.direction = state.ray.direction;
        around.uv = uv;
        around.surface = true;
    }

    std::size_t lane;  ///< its place in the tile
    texture::Surroundings around;
    /// Texture maps stay there: normals of neighbours that are looked at later go through their transformations too, as
    /// in POV-Ray.
    texture::Enclosing enclosing;
    const PrefetchedPigments* prefetched = nullptr;  ///< pigments of the texture's layers, where they are known already
};

}  // namespace trace
