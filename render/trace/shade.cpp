#include "render/trace/shade.h"

#include "render/trace/shade_context.h"

namespace trace {
namespace {

/// Beyond this distance a shadow ray starts at the hit: from a far light, t would lose digits against the tolerance.
constexpr double kFarLight = 1e5;

glm::dvec3 facing_normal(const HitDetails& details, const glm::dvec3& direction)
{
    return glm::dot(details.normal, direction) > 0.0 ? -details.normal : details.normal;
}

/// One tile of camera rays on its way to colours.
class Tile {
public:
    Tile(Context& context, const RayTile& rays, const HitTile& hits, std::size_t base)
        : context_(context), scratch_(context.scratch.shade), rays_(rays), hits_(hits), base_(base),
          lights_(context.scene.lights.lights.size())
    {
    }

    void find_details()
    {
        for (int i = 0; i < rays_.count; ++i)
            if (hits_.at(i).found()) details(i) = hit_details(context_, rays_.ray(i), hits_.at(i));
    }

    /// Shadow rays of one light for the whole tile; what they find waits in the hits' LightSamples.
    void shadow(std::size_t which)
    {
        const light::Light& light = context_.scene.lights.lights[which];
        if (light.shadowless || light.area || context_.scene.settings.quality < 4) return;
        RayTile& beam = scratch_.rays;
        beam.count = 0;
        beam.common_origin = light.from_one_point();
        for (int i = 0; i < rays_.count; ++i)
            if (asks_for_light(i) && !near_enough(light, i)) beam.common_origin = false;
        for (int i = 0; i < rays_.count; ++i)
            if (asks_for_light(i)) add_ray(light, which, i);
        if (beam.count == 0) return;
        context_.scratch.counts.shadow += static_cast<std::uint64_t>(beam.count);
        context_.world.shadow(beam, context_.scratch.geometry, scratch_.shadows.data());
        for (std::size_t k = 0; k < static_cast<std::size_t>(beam.count); ++k) {
            LightSample& s = sample(scratch_.lane[k], which);
            if (scratch_.shadows[k] == Shadow::Filtered) continue;  // found when shading asks, one by one
            s.shadowed = scratch_.shadows[k] == Shadow::Clear ? s.lit.color : glm::vec3(0);
            s.shadow_known = true;
        }
    }

    scene::Color color(int i)
    {
        RayState state{rays_.ray(i), 1.0f, 0, plan::RayKind::Image, {}};
        for (const std::uint32_t interior : context_.scene.camera_interiors) state.interiors.append(interior);
        const Hit hit = hits_.at(i);
        if (!hit.found()) return through_air(context_, state, csg::kInfinity, sky_color(context_, state));
        const scene::Color c = shade_hit(context_, state, hit, details(i), 1, first_light(i));
        return through_air(context_, state, hit.t, c);
    }

private:
    HitDetails& details(int i) { return scratch_.details[static_cast<std::size_t>(i)]; }
    std::size_t first_light(int i) const { return base_ + static_cast<std::size_t>(i) * lights_; }
    LightSample& sample(int i, std::size_t which) { return scratch_.lights[first_light(i) + which]; }

    bool asks_for_light(int i) const
    {
        const Hit hit = hits_.at(i);
        if (!hit.found()) return false;
        const std::uint32_t texture = context_.scene.surfaces[hit.surface].texture;
        return texture != plan::kNone && context_.scene.textures.textures[texture].lit;
    }

    bool near_enough(const light::Light& light, int i)
    {
        return glm::distance(light.location, details(i).point) < kFarLight;
    }

    void add_ray(const light::Light& light, std::size_t which, int i)
    {
        LightSample& s = sample(i, which);
        const HitDetails& at = details(i);
        s.lit = light::illuminate(light, at.point);
        s.illuminated = true;
        // Bent normals may face a light that the surface turns away from: rare, asked for one by one.
        if (glm::dot(facing_normal(at, rays_.ray(i).direction), s.lit.direction) < kNearlyZero) return;
        if (s.lit.color == glm::vec3(0)) return;
        const double end = s.lit.distance - kShadowTolerance;
        if (end <= kShadowTolerance) return;
        RayTile& beam = scratch_.rays;
        const auto k = static_cast<std::size_t>(beam.count++);
        const glm::dvec3 origin = beam.common_origin ? light.location : at.point;
        const glm::dvec3 direction = beam.common_origin ? -s.lit.direction : s.lit.direction;
        beam.ox[k] = origin.x;
        beam.oy[k] = origin.y;
        beam.oz[k] = origin.z;
        beam.dx[k] = direction.x;
        beam.dy[k] = direction.y;
        beam.dz[k] = direction.z;
        beam.t_min[k] = kShadowTolerance;
        beam.t_max[k] = end;
        scratch_.lane[k] = static_cast<std::uint8_t>(i);
    }

    Context& context_;
    ShadeScratch& scratch_;
    const RayTile& rays_;
    const HitTile& hits_;
    std::size_t base_, lights_;
};

}  // namespace

void shade_tile(const plan::CompiledScene& scene, const RayTile& rays, const HitTile& hits, scene::Color* out,
                Scratch& scratch)
{
    Context context{scene, scene.world(), scratch};
    if (scratch.shade.surfaces.empty()) scratch.shade.surfaces = surface_traits(scene);
    auto& stack = scratch.shade.lights;
    const std::size_t base = stack.size();
    stack.resize(base + scene.lights.lights.size() * static_cast<std::size_t>(rays.count));
    Tile tile(context, rays, hits, base);
    tile.find_details();
    for (std::size_t i = 0; i < scene.lights.lights.size(); ++i) tile.shadow(i);
    for (int i = 0; i < rays.count; ++i) out[i] = tile.color(i);
    stack.resize(base);
}

}  // namespace trace
