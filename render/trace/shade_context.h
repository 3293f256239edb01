#pragma once

#include "render/plan/compiled_scene.h"
#include "render/scene/color.h"
#include "render/texture/evaluate.h"
#include "render/trace/geometry.h"
#include "render/trace/scratch.h"

#include <array>

/// Inside of shading: the state of one ray and of one hit, and the steps that call each other in recursion.
namespace trace {

inline constexpr double kMinDistance = 1e-4;        ///< nearer hits of camera and secondary rays do not count (spec 3, 3.1)
inline constexpr double kShadowTolerance = 1e-3;    ///< the same for shadow rays, at both ends
inline constexpr double kNearlyZero = 1e-10;        ///< light and index differences below it count as none
inline constexpr float kDark = 1e-10f;              ///< kNearlyZero for colours

/// The interiors a ray is inside of, in order of entry (spec 3, 8.2). Entries past the capacity are forgotten.
class InteriorList {
public:
    InteriorList() = default;
    InteriorList(const InteriorList& other) { *this = other; }
    /// Copies what is there: a list is handed down with every ray, and hardly ever has more than two entries.
    InteriorList& operator=(const InteriorList& other)
    {
        count_ = other.count_;
        for (std::size_t i = 0; i < count_; ++i) items_[i] = other.items_[i];
        return *this;
    }
    void append(std::uint32_t interior)
    {
        if (count_ < kCapacity) items_[count_++] = interior;
    }
    void remove_first(std::uint32_t interior);
    bool holds(std::uint32_t interior) const;
    bool empty() const { return count_ == 0; }
    std::size_t size() const { return count_; }
    std::uint32_t last() const { return items_[count_ - 1]; }
    std::uint32_t operator[](std::size_t i) const { return items_[i]; }

private:
    static constexpr std::size_t kCapacity = 32;
    std::array<std::uint32_t, kCapacity> items_;
    std::size_t count_ = 0;
};

/// One ray with what it inherits.
struct RayState {
    csg::Ray ray;
    float weight = 1;                ///< share of the pixel; below adc_bailout the ray is not traced
    int level = 0;                   ///< levels in use before this ray
    plan::RayKind kind = plan::RayKind::Image;
    InteriorList interiors;
};

/// Everything shading reads and writes besides the ray.
struct Context {
    const plan::CompiledScene& scene;
    csg::World world;
    Scratch& scratch;
};

/// Point, normal and what else the surface's textures ask for.
inline HitDetails hit_details(const Context& context, const csg::Ray& ray, const Hit& hit)
{
    return context.world.details(ray, hit, context.scratch.shade.surfaces[hit.surface].needs_uv);
}

/// A hit being shaded.
struct HitContext {
    const RayState& state;
    const plan::Surface& surface;
    glm::dvec3 point;
    glm::dvec3 normal;               ///< N0: raw, unit, faces the viewer
    double distance;                 ///< from the ray's origin
    int level;                       ///< levels in use including this ray's
    std::size_t lights;              ///< where this hit's LightSamples start in the scratch stack
    texture::Surroundings around;
    std::array<std::uint32_t, 8> enclosing{};  ///< patterns of the texture maps around, outside in
    std::size_t enclosing_count = 0;
};

/// Colour along a ray. `straight`: an unbent continuation, which uses no level (spec 3, section 2).
scene::Color trace_ray(Context& context, const RayState& state, bool straight);

/// Fog where the interiors around the ray allow it; `length` may be infinite (spec 3, section 2).
scene::Color through_air(const Context& context, const RayState& state, double length, const scene::Color& color);

/// Colour of a hit. `details` as World gives them; `first_light`: samples already filled in for this hit.
scene::Color shade_hit(Context& context, const RayState& state, const Hit& hit, const HitDetails& details, int level,
                       std::size_t first_light);

/// Colour of a texture at p (its own space's point).
scene::Color shade_texture(Context& context, HitContext& hit, std::uint32_t texture, const glm::dvec3& p);

/// Colour of a plain texture: all layers, transmission and reflection (spec 3, section 6).
scene::Color shade_layers(Context& context, HitContext& hit, const texture::Texture& texture, const glm::dvec3& p);

/// Sum over the lights for one layer (spec 3, 7.4). alpha: the layer's opacity factor.
glm::vec3 direct_light(Context& context, HitContext& hit, const texture::Finish& finish, const scene::Color& pigment,
                       const glm::dvec3& normal, double alpha);

/// Colour of a light after everything between it and the point, which `interiors` hold (spec 3, section 13).
glm::vec3 filtered_light(Context& context, const glm::dvec3& point, const InteriorList& interiors,
                         const light::Illumination& lit, glm::vec3 color);

/// Share of light that a surface lets through, for shadow rays (spec 3, 13.2).
glm::vec3 surface_filter(Context& context, const RayState& ray, const Hit& hit, const HitDetails& details);

/// What the transmitted ray brings; `total` is set on total internal reflection (spec 3, section 8).
scene::Color transmitted(Context& context, const HitContext& hit, const glm::dvec3& top_normal, float weight,
                         const texture::Finish& top_finish, bool& total);

/// Colour mirrored about `normal` (spec 3, section 10).
scene::Color reflected(Context& context, const HitContext& hit, const glm::dvec3& normal, float weight,
                       glm::dvec3& direction);

/// Relative index for a fresnel reflection (spec 3, 7.9).
double fresnel_index(const Context& context, const HitContext& hit);

/// Fading of light over a distance inside an interior; 1 where it does not fade (spec 3, 9.1).
glm::vec3 interior_fade(const plan::Interior& interior, double distance, bool shadow);

/// Iridescence of light from `l` (spec 3, 7.11).
glm::vec3 film_color(const Context& context, const HitContext& hit, const texture::Finish& finish,
                     const glm::dvec3& normal, const glm::dvec3& l);

/// What a ray sees that meets nothing (spec 2, sections 14 and 15).
scene::Color sky_color(const Context& context, const RayState& state);

/// Fog over the length of a ray; infinite length is allowed (spec 2, section 16).
scene::Color through_fog(const Context& context, const RayState& state, double length, scene::Color color);

}  // namespace trace
