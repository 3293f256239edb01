#pragma once

#include "render/plan/compiled_scene.h"
#include "render/scene/base/color.h"
#include "render/texture/evaluate.h"
#include "render/trace/air/air.h"
#include "render/trace/geometry.h"
#include "render/trace/queue/ray_state.h"
#include "render/trace/queue/scratch.h"

#include <algorithm>
#include <array>
#include <cmath>

/// Inside of shading: one hit, and what the stages ask of each other (docs/shading.md).
namespace trace {

class DirectBatch;
class MediaShadows;

inline constexpr double kNearlyZero = 1e-10;  ///< light and index differences below it count as none
inline constexpr float kDark = 1e-10f;        ///< kNearlyZero for colours

inline bool dark(const glm::vec3& c)
{
    return !(std::abs(c.x) > kDark || std::abs(c.y) > kDark || std::abs(c.z) > kDark);
}
inline bool black(const glm::vec3& c) { return c.x == 0.0f && c.y == 0.0f && c.z == 0.0f; }
inline float largest(const glm::vec3& c) { return std::max({c.x, c.y, c.z}); }

struct IndirectLight;
namespace radiosity {
struct BounceRules;
struct Filling;
}  // namespace radiosity

/// Everything shading reads and writes besides the ray.
struct Context {
    Context(const plan::CompiledScene& of, Scratch& own, const IndirectLight* light)
        : scene(of), world(of.world()), scratch(own), indirect(light), lights(of.lights),
          max_trace_level(of.settings.max_trace_level), adc_bailout(of.settings.adc_bailout)
    {}
    /// The same with another scratch, for work in the midst of a tile.
    Context(const Context& outer, Scratch& own)
        : scene(outer.scene), world(outer.world), scratch(own), indirect(outer.indirect), lights(outer.lights),
          max_trace_level(outer.max_trace_level), adc_bailout(outer.adc_bailout), bounce(outer.bounce),
          below(outer.below), filling(outer.filling)
    {}
    /// For rays that gather light from within shading, by the rules of the bounce that they start at.
    Context gathering(const radiosity::BounceRules& rules) const;

    const plan::CompiledScene& scene;
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
    return context.world.details(ray, hit, context.scratch.shade.traits.surfaces[hit.surface].needs_uv);
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

/// Whether light groups let the light shine on the surface (spec 3, 12.10).
inline bool shines_on(const light::Light& light, const plan::Surface& surface)
{
    return light.group == surface.light_group || (light.group == 0 && surface.global_lights);
}

/// A hit whose textures are gone through. Made in place, member by member: a copy of what was just written in smaller
/// pieces waits for all of them.
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
    std::array<std::uint32_t, 16>
        enclosing;  ///< the texture maps that normals are carried through, the first one first
    std::size_t enclosing_count = 0;
    const PrefetchedPigments* prefetched = nullptr;  ///< pigments of the texture's layers, where they are known already
};

/// Light of a row of DirectBatch whose lights are looked up one by one (spec 3, 7.4). grains: numbers of `crand` asked
/// for so far.
struct ScalarRow {
    const HitPlace& hit;
    const texture::Finish& finish;
    const scene::Color& pigment;
    const glm::dvec3& normal;
    double alpha;
    const LightSample* samples;  ///< by light
    std::uint32_t& grains;
};

/// Goes through all textures of a hit: their rows go to the batch, nodes and rays to the queue; its colour is to come
/// into `out`.
void shade_surface(Context& context, DirectBatch& batch, HitContext& hit, const HitDetails& details,
                   std::uint32_t texture, ColorSlot out);

/// The same of one texture at p (its own space's point).
void shade_texture(Context& context, DirectBatch& batch, HitContext& hit, std::uint32_t texture, const glm::dvec3& p,
                   ColorSlot out);

/// The same of a plain texture: all layers (spec 3, section 6).
void shade_layers(Context& context, DirectBatch& batch, HitContext& hit, const texture::Texture& texture,
                  const glm::dvec3& p, ColorSlot out);

/// Sum over the lights for one row (spec 3, 7.4).
glm::vec3 direct_light(Context& context, const ScalarRow& row);

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

/// Share of light that a surface lets through, for shadow rays (spec 3, 13.2).
glm::vec3 surface_filter(Context& context, const RayState& ray, const Hit& hit, const HitDetails& details);

/// What the only layer of a texture lets through, in LayerStack::pass()'s order of operations.
inline glm::vec3 layer_filter(const scene::Color& c, const texture::Finish& finish, const glm::vec3& reflectivity)
{
    const glm::vec3 filter = c.filter * c.rgb() + c.transmit;
    return finish.conserve_energy ? filter * glm::min(glm::vec3(1.0f), 1.0f - reflectivity) : filter;
}
inline float residual_of(const glm::vec3& filter) { return std::min(1.0f, std::abs(scene::grey(filter))); }

/// Weight of the ray off a mirror that reflects; residual: of the layers above.
inline float mirror_weight(float weight, float residual, const texture::Finish& finish, const glm::vec3& reflectivity)
{
    const float strength = finish.fresnel ? largest(reflectivity)
                                          : std::max(largest(finish.reflection_max), largest(finish.reflection_min));
    return weight * residual * std::max(0.0f, strength);
}

/// What the layers of a texture leave to the rays that go on.
struct LayerStack {
    explicit LayerStack(std::vector<Mirror>& reused) : mirrors(reused) { mirrors.clear(); }

    glm::vec3 filter{1};  ///< what they let through
    float residual = 1;   ///< how much that is, at most 1
    glm::dvec3 top_normal{0};
    std::vector<Mirror>& mirrors;  ///< of the layers so far, the top layer's first

    /// One layer more: its pigment lets light through, its finish mirrors some.
    void pass(const scene::Color& c, const texture::Finish& finish, const glm::vec3& reflectivity)
    {
        filter *= c.filter * c.rgb() + c.transmit;
        if (finish.conserve_energy) filter *= glm::min(glm::vec3(1.0f), 1.0f - reflectivity);
        residual = residual_of(filter);
    }
};

/// A layer's mirror at a hit; residual: of the layers above.
void find_mirror(const Context& context, const HitPlace& hit, const texture::Finish& finish, const scene::Color& c,
                 const glm::dvec3& normal, float residual, Mirror& mirror);

/// The node of a texture's layers, whose own light is still to come, with the rays that go on from it. Its index in the
/// queue.
std::uint32_t scatter(Context& context, const HitPlace& hit, const LayerStack& stack, ColorSlot out);

/// A mirrored colour as the finish wants it (spec 3, section 6).
glm::vec3 raised(const scene::Color& c, float exponent);

/// Iridescence of light from `l` (spec 3, 7.11).
glm::vec3 film_color(const Context& context, const HitPlace& hit, const texture::Finish& finish,
                     const glm::dvec3& normal, const glm::dvec3& l);

/// Share of light that fog lets pass over a length.
glm::vec3 fog_share(const Context& context, const csg::Ray& ray, double length);

/// Share of light that fog and media of the whole scene let pass between two distances along a shadow ray (spec
/// 6, 2.8): fog where it is inside of nothing solid, media also where it is, unless the stretch ends at the light.
glm::vec3 atmosphere_share(const Context& context, const RayState& ray, double from, double to, bool at_light,
                           const ShadowAir& air = {});

/// The rainbows that a ray of this length sees (spec 2, section 17).
Air rainbow_air(const Context& context, const csg::Ray& ray, double length);

}  // namespace trace
