#include "render/texture/evaluate.h"
#include "render/trace/shade_context.h"

#include <cmath>

/// Shadow rays through transparent things (spec 3, section 13).
namespace trace {
namespace {

struct Passing {
    Context& context;
    const plan::Surface& surface;
    const csg::Ray& ray;
    glm::dvec3 normal;               ///< faces against the shadow ray
    texture::Surroundings around;

    glm::vec3 layers(const texture::Texture& texture, const glm::dvec3& p)
    {
        const auto& set = context.scene.textures;
        const float power =
            surface.interior == plan::kNone ? 0.0f : context.scene.interiors[surface.interior].caustics_power;
        glm::vec3 light(1);
        for (std::uint32_t i = texture.count; i-- > 0;) {
            const texture::Layer& layer = set.layers[texture.first + i];
            const scene::Color c = texture::pigment_color(set, layer.pigment, p, around);
            light *= c.filter * c.rgb() + c.transmit;
            if (power != 0.0f) {
                const glm::dvec3 n = layer.normal == texture::kNone
                                         ? normal
                                         : texture::perturb(set, layer.normal, normal, p, around);
                const double focus = std::pow(std::abs(glm::dot(n, ray.direction)), static_cast<double>(power));
                light *= static_cast<float>(1.0 + focus);
            }
        }
        return light;
    }

    glm::vec3 through(std::uint32_t index, const glm::dvec3& p)
    {
        const auto& set = context.scene.textures;
        const texture::Texture& texture = set.textures[index];
        using Kind = texture::Texture::Kind;
        if (texture.kind == Kind::Layers) return layers(texture, p);
        if (texture.kind == Kind::Uv) return through(set.children[texture.first], {around.uv.x, around.uv.y, 0.0});
        const texture::Pattern& pattern = set.patterns[texture.pattern];
        const glm::dvec3 q = texture::warp_point(set, pattern, p);
        if (texture.kind == Kind::Average) {
            glm::vec3 sum(0);
            float weights = 0;
            for (std::uint32_t i = texture.first; i < texture.first + texture.count; ++i) {
                sum += set.keys[i] * through(set.children[i], q);
                weights += set.keys[i];
            }
            return sum / weights;
        }
        const double v = texture::pattern_value(set, pattern, q, around);
        const texture::Blend blend = texture::blend_at(set, texture.first, texture.count, v);
        const glm::vec3 lower = through(set.children[blend.lower], q);
        if (blend.lower == blend.upper) return lower;
        return lower + static_cast<float>(blend.share) * (through(set.children[blend.upper], q) - lower);
    }
};

}  // namespace

glm::vec3 surface_filter(Context& context, const RayState& state, const Hit& hit, const HitDetails& details)
{
    const plan::Surface& surface = context.scene.surfaces[hit.surface];
    const glm::dvec3& d = state.ray.direction;
    const bool from_inside = glm::dot(details.normal, d) > 0.0;
    const std::uint32_t texture =
        from_inside && surface.interior_texture != plan::kNone ? surface.interior_texture : surface.texture;
    if (texture == plan::kNone) return glm::vec3(1.0f);
    const glm::dvec3 normal = from_inside ? -details.normal : details.normal;
    Passing passing{context, surface, state.ray, normal, {details.point, normal, d, details.uv, true}};
    const glm::dvec3 p = surface.uv_mapping ? glm::dvec3(details.uv.x, details.uv.y, 0.0) : details.point;
    if (!surface.blends() || texture != surface.texture) return passing.through(texture, p);
    return details.weights.x * passing.through(texture, p) + details.weights.y * passing.through(surface.corner_textures[0], p) +
           details.weights.z * passing.through(surface.corner_textures[1], p);
}

glm::vec3 filtered_light(Context& context, const glm::dvec3& point, const InteriorList& interiors,
                         const light::Illumination& lit, glm::vec3 color)
{
    const double end = lit.distance - kShadowTolerance;
    if (end <= kShadowTolerance) return color;
    ++context.scratch.counts.shadow;
    RayState ray{{point, lit.direction}, 1.0f, 0, plan::RayKind::Shadow, interiors};
    auto& crossings = context.scratch.crossings;
    const Shadow met =
        context.world.shadow_crossings(ray.ray, kShadowTolerance, end, context.scratch.geometry, crossings);
    if (met == Shadow::Clear) return color;
    if (met == Shadow::Blocked) return glm::vec3(0.0f);
    double last = 0.0;
    for (const Hit& crossing : crossings) {
        if (crossing.t - last <= kShadowTolerance) continue;  // the next ray would not see it
        const plan::Surface& surface = context.scene.surfaces[crossing.surface];
        const SurfaceTraits& traits = context.scratch.shade.surfaces[crossing.surface];
        color *= traits.steady_filter
                     ? traits.filter
                     : surface_filter(context, ray, crossing, hit_details(context, ray.ray, crossing));
        const bool inside = surface.interior != plan::kNone && ray.interiors.holds(surface.interior);
        if (inside) color *= interior_fade(context.scene.interiors[surface.interior], crossing.t - last, true);
        // Signed on purpose: light below zero never updates the list (spec 3, 13.2).
        if (surface.interior != plan::kNone && !(color.x < kDark && color.y < kDark && color.z < kDark)) {
            if (inside)
                ray.interiors.remove_first(surface.interior);
            else
                ray.interiors.append(surface.interior);
        }
        last = crossing.t;
    }
    return color;
}

}  // namespace trace
