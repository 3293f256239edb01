#pragma once

#include "render/plan/compiled_scene.h"
#include "render/scene/color.h"
#include "render/texture/evaluate.h"
#include "render/trace/geometry.h"
#include "render/trace/ray_state.h"
#include "render/trace/scratch.h"

#include <algorithm>
#include <array>

/// Inside of shading: the state of one ray and of one hit, and the steps that call each other in recursion.
namespace trace {

inline constexpr double kNearlyZero = 1e-10;        ///< light and index differences below it count as none
inline constexpr float kDark = 1e-10f;              ///< kNearlyZero for colours

inline bool black(const glm::vec3& c) { return c.x == 0.0f && c.y == 0.0f && c.z == 0.0f; }
inline float largest(const glm::vec3& c) { return std::max({c.x, c.y, c.z}); }

/// Everything shading reads and writes besides the ray.
struct Context {
    const plan::CompiledScene& scene;
    csg::World world;
    Scratch& scratch;
};

/// Point, normal and what else the surface's textures ask for.
inline HitDetails hit_details(const Context& context, const csg::Ray& ray, const Hit& hit)
{
    return context.world.details(ray, hit, context.scratch.shade.traits.surfaces[hit.surface].needs_uv);
}

/// Where a ray met a surface: all that the rays that go on from there depend on.
struct HitPlace {
    const RayState& state;
    const Hit& met;
    const plan::Surface& surface;
    glm::dvec3 point;
    glm::dvec3 normal;               ///< N0: raw, unit, faces the viewer
    int level;                       ///< levels in use including this ray's
    bool from_inside;                ///< the normal had to be turned
};

/// Whether light groups let the light shine on the surface (spec 3, 12.10).
inline bool shines_on(const light::Light& light, const plan::Surface& surface)
{
    return light.group == surface.light_group || (light.group == 0 && surface.global_lights);
}

/// A hit being shaded.
struct HitContext : HitPlace {
    std::size_t lights;              ///< where this hit's LightSamples start in the scratch stack
    texture::Surroundings around;
    std::array<std::uint32_t, 16> enclosing{}; ///< the texture maps that normals are carried through, the first one first
    std::size_t enclosing_count = 0;
    std::uint32_t grains = 0;             ///< random numbers of `crand` asked for so far
    const LayersAhead* ahead = nullptr;   ///< pigments of the texture's layers, where they are known already
};

/// Colour along a ray. `straight`: an unbent continuation, which uses no level (spec 3, section 2).
scene::Color trace_ray(Context& context, const RayState& state, bool straight);

/// Fog where the interiors around the ray allow it.
scene::Color through_hollow(const Context& context, const RayState& state, double length, const scene::Color& color);

inline bool foggy(const Context& context) { return !context.scene.fogs.empty() && context.scene.settings.quality >= 9; }

/// What becomes of a colour over the length of the ray that sees it; it may be infinite (spec 3, section 2).
inline scene::Color through_air(const Context& context, const RayState& state, double length, const scene::Color& color)
{
    return foggy(context) ? through_hollow(context, state, length, color) : color;
}

/// Colour of a hit. `details` as World gives them; `first_light`: samples already filled in for this hit; `ahead`: pigments.
scene::Color shade_hit(Context& context, const RayState& state, const Hit& hit, const HitDetails& details, int level,
                       std::size_t first_light, const LayersAhead* ahead = nullptr);

/// Colour of a texture at p (its own space's point).
scene::Color shade_texture(Context& context, HitContext& hit, std::uint32_t texture, const glm::dvec3& p);

/// Colour of a plain texture: all layers, transmission and reflection (spec 3, section 6).
scene::Color shade_layers(Context& context, HitContext& hit, const texture::Texture& texture, const glm::dvec3& p);

/// Sum over the lights for one layer (spec 3, 7.4). alpha: the layer's opacity factor.
glm::vec3 direct_light(Context& context, HitContext& hit, const texture::Finish& finish, const scene::Color& pigment,
                       const glm::dvec3& normal, double alpha);

/// Colour of a light after everything between it and the point, which `interiors` hold (spec 3, section 13).
/// `tolerance`: of shadow rays from this point; in_fog: fog dims it on its way; first: the first crossing
/// from the point, where it is known and solids are such that the others have to be asked for one by one (SceneTraits::restarts).
glm::vec3 filtered_light(Context& context, const glm::dvec3& point, double tolerance, const InteriorList& interiors,
                         const light::Illumination& lit, glm::vec3 color, bool in_fog = false, const Hit* first = nullptr);

/// The same of lit.color where the crossings of surfaces that let light through are known, nearest first from the point or
/// from the light; they are turned round in place.
glm::vec3 crossed_light(Context& context, const glm::dvec3& point, double tolerance, const InteriorList& interiors,
                        const light::Illumination& lit, bool from_light, Hit* crossings, std::size_t count, bool in_fog = false);

/// Share of light that a surface lets through, for shadow rays (spec 3, 13.2).
glm::vec3 surface_filter(Context& context, const RayState& ray, const Hit& hit, const HitDetails& details);

/// The ray that goes on through a surface, and what light loses on its way (spec 3, section 8).
struct Onward {
    RayState ray;
    glm::vec3 fade{1};
    bool straight = true;            ///< unbent: uses no level
    bool total = false;              ///< total internal reflection: `ray` is the mirrored one
    int samples = 0;                 ///< of the spectrum: `ray` has no direction yet, dispersed() finds one for each
    double ratio = 1, dispersion = 1;   ///< how the interface bends light of 555 nm, and others (8.5)
};

/// False where nothing is behind the surface: it has no interior.
bool onward(const Context& context, const HitPlace& hit, const glm::dvec3& top_normal, float weight, Onward& out);

/// The mean of what rays of all wavelengths see beyond a surface; its `samples` are not 0 (spec 3, 8.5). Those that are mirrored within
/// take on the iridescence of the top layer's finish.
scene::Color dispersed(Context& context, const HitPlace& hit, const glm::dvec3& top_normal, const texture::Finish& top_finish, const Onward& onward);

/// The ray mirrored about `normal` (spec 3, section 10).
RayState mirrored(const Context& context, const HitPlace& hit, const glm::dvec3& normal, float weight);

/// A mirrored colour as the finish wants it (spec 3, 10.3).
glm::vec3 raised(const scene::Color& c, float exponent);

/// What the transmitted ray brings; `total` is set on total internal reflection (spec 3, section 8).
scene::Color transmitted(Context& context, const HitContext& hit, const glm::dvec3& top_normal, float weight,
                         const texture::Finish& top_finish, bool& total);

/// Colour mirrored about `normal` (spec 3, section 10).
scene::Color reflected(Context& context, const HitContext& hit, const glm::dvec3& normal, float weight,
                       glm::dvec3& direction);

/// Relative index for a fresnel reflection (spec 3, 7.9).
double fresnel_index(const Context& context, const HitPlace& hit);

/// Fading of light over a distance inside an interior; 1 where it does not fade (spec 3, 9.1).
glm::vec3 interior_fade(const plan::Interior& interior, double distance, bool shadow);

/// Iridescence of light from `l` (spec 3, 7.11).
glm::vec3 film_color(const Context& context, const HitPlace& hit, const texture::Finish& finish,
                     const glm::dvec3& normal, const glm::dvec3& l);

/// What a ray sees that meets nothing (spec 2, sections 14 and 15).
scene::Color sky_color(const Context& context, const RayState& state);

/// Share of light that fog lets pass over a length.
glm::vec3 fog_share(const Context& context, const csg::Ray& ray, double length);

/// Fog over the length of a ray; infinite length is allowed (spec 2, section 16).
scene::Color through_fog(const Context& context, const RayState& state, double length, scene::Color color);

}  // namespace trace
