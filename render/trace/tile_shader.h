#pragma once

#include "render/trace/look_ahead.h"
#include "render/trace/shade_context.h"
#include "render/trace/shade_light.h"
#include "render/trace/wave.h"

#include <algorithm>

/// Shading of one tile's hits. Compiled once per instruction set.
namespace trace {

/// Beyond this distance a shadow ray starts at the hit: from a far light, t would lose digits against the tolerance.
inline constexpr double kFarLight = 1e5;

/// Lit from one point with one colour everywhere: its directions are found in vector lanes.
inline bool steady(const light::Light& light)
{
    return light.kind == light::Light::Kind::Point && !light.parallel && !light.area && !(light.fade_power > 0.0);
}

/// One tile of rays on its way to colours. Hits of surfaces with one layer go through the lights together and are done
/// then, but for the rays that go on from them; the others find their first shadow rays answered and are shaded one by one.
class TileShader {
public:
    /// waiting: what the rays inherit; none for camera rays, which share `camera`.
    TileShader(Context& context, const RayTile& rays, const HitTile& hits, const RayState& camera, const WaitingRay* waiting)
        : context_(context), scratch_(context.scratch.shade), rays_(rays), hits_(hits), camera_(camera), waiting_(waiting),
          lights_(context.scene.lights.lights.size()), shadows_(context.scene.settings.quality >= 4)
    {
    }

    /// Details and what is to be done with each hit; true if some need LightSamples.
    bool prepare()
    {
        const auto& lights = context_.scene.lights.lights;
        const plan::Settings& settings = context_.scene.settings;
        const bool small = settings.quality >= 2 &&
                           std::none_of(lights.begin(), lights.end(), [](const light::Light& l) { return l.by_points(); });
        const bool go_on = settings.quality >= 8 && settings.adc_bailout < 1.0 && !scratch_.wave.full();
        bool general = false;
        PigmentBatch& pigments = scratch_.pigments;
        pigments.clear();
        for (int i = 0; i < rays_.count; ++i) {
            const auto k = static_cast<std::size_t>(i);
            scratch_.plain[k].finish = nullptr;
            scratch_.layers[k].texture = plan::kNone;
            const Hit hit = hits_.at(i);
            if (!hit.found()) {
                scratch_.hits.set(k, glm::dvec3(0), glm::dvec3(0));
                continue;
            }
            const csg::Ray ray = rays_.ray(i);
            HitDetails& at = details(i) = hit_details(context_, ray, hit);
            const bool from_inside = glm::dot(at.normal, ray.direction) > 0.0;
            scratch_.hits.set(k, at.point, from_inside ? -at.normal : at.normal);
            const SurfaceTraits& traits = scratch_.traits.surfaces[hit.surface];
            const LoneLayer& layer = from_inside ? traits.inner : traits.outer;
            if (small && layer.index != plan::kNone && (go_on || !layer.goes_on)) {
                begin_plain(i, layer, hit);
            } else {
                general = true;
                begin_layers(i, hit, from_inside ? traits.inner_layers : traits.outer_layers);
            }
        }
        pigments.run(context_.scene.textures, [this](std::size_t k, const scene::Color& c) { color_plain(k, c); });
        if (general) look_ahead(scratch_, context_.scene.textures, rays_.count, static_cast<float>(settings.adc_bailout));
        for (int i = rays_.count; i % csg::kTileSide != 0; ++i)
            scratch_.hits.set(static_cast<std::size_t>(i), glm::dvec3(0), glm::dvec3(0));
        return general;
    }

    /// Where the tile's LightSamples start in the scratch stack.
    void use_samples(std::size_t base) { base_ = base; }

    /// One light for the whole tile: it is added to plain hits, and waits in the LightSamples of the others.
    void light(std::size_t which)
    {
        const light::Light& light = context_.scene.lights.lights[which];
        if (light.by_points()) return;
        const bool one_color = steady(light);
        if (one_color) toward_point(light, scratch_.hits, rays_.count, scratch_.light);
        const bool shadows = shadows_ && !light.shadowless;
        RayTile& beam = scratch_.rays;
        beam.count = 0;
        beam.common_origin = light.from_one_point() && !scratch_.traits.beside;
        for (int i = 0; i < rays_.count; ++i) {
            if (!asks_for_light(i)) continue;
            const auto k = static_cast<std::size_t>(i);
            if (one_color) {
                scratch_.lit_colors[k] = light.color;
            } else {
                const light::Illumination lit = light::illuminate(light, scratch_.hits.point(k));
                scratch_.light.x[k] = lit.direction.x;
                scratch_.light.y[k] = lit.direction.y;
                scratch_.light.z[k] = lit.direction.z;
                scratch_.light.distance[k] = lit.distance;
                scratch_.lit_colors[k] = lit.color;
            }
            if (!(scratch_.light.distance[k] < kFarLight)) beam.common_origin = false;
        }
        for (int i = 0; i < rays_.count; ++i)
            if (asks_for_light(i)) ask(light, which, i, shadows);
        if (beam.count != 0) answer(light, which);
    }

    void color(int i)
    {
        const Hit hit = hits_.at(i);
        const auto k = static_cast<std::size_t>(i);
        const PlainHit& plain = scratch_.plain[k];
        const bool done = plain.finish != nullptr && !plain.goes_on;
        if (done && !foggy(context_)) {
            give(i, scene::Color::of(plain.glow + plain.lit));
            return;
        }
        RayState own;
        if (waiting_ == nullptr) {
            own = camera_;
            own.ray = rays_.ray(i);
        }
        const RayState& state = waiting_ == nullptr ? own : waiting_[k].state;
        if (!hit.found()) {
            give(i, through_air(context_, state, csg::kInfinity, sky_color(context_, state)));
        } else if (done) {
            give(i, through_air(context_, state, hit.t, scene::Color::of(plain.glow + plain.lit)));
        } else if (plain.finish != nullptr) {
            const HitPlace place{state, context_.scene.surfaces[hit.surface], scratch_.hits.point(k), scratch_.hits.normal(k), hit.t, level(i)};
            add_branch(context_, place, *plain.finish, plain.pigment, plain.glow + plain.lit, place_of(i), reach(i) + hit.t);
        } else {
            give(i, through_air(context_, state, hit.t, shade_hit(context_, state, hit, details(i), level(i), first_light(i), &scratch_.layers[k])));
        }
    }

private:
    int level(int i) const { return waiting_ == nullptr ? 1 : waiting_[i].level; }
    double reach(int i) const { return waiting_ == nullptr ? 0.0 : waiting_[i].reach; }
    Place place_of(int i) const { return waiting_ == nullptr ? static_cast<Place>(i) : waiting_[i].place; }
    const InteriorList& interiors(std::size_t k) const { return (waiting_ == nullptr ? camera_ : waiting_[k].state).interiors; }
    void give(int i, const scene::Color& c) { scratch_.wave.colors[place_of(i)] = c; }

    HitDetails& details(int i) { return scratch_.details[static_cast<std::size_t>(i)]; }
    std::size_t first_light(int i) const { return base_ + static_cast<std::size_t>(i) * lights_; }
    LightSample& sample(int i, std::size_t which) { return scratch_.lights[first_light(i) + which]; }

    void begin_plain(int i, const LoneLayer& lone, const Hit& hit)
    {
        const auto k = static_cast<std::size_t>(i);
        const auto& set = context_.scene.textures;
        const texture::Layer& layer = set.layers[lone.index];
        PlainHit& plain = scratch_.plain[k];
        plain.finish = &set.finishes[layer.finish];
        plain.goes_on = lone.goes_on;
        const texture::Pigment& pigment = set.pigments[layer.pigment];
        if (pigment.kind == texture::Pigment::Kind::Solid) return color_plain(k, pigment.color);
        surround(i);
        scratch_.pigments.ask(k, layer.pigment, pattern_point(i, hit), scratch_.around[k]);
    }

    void color_plain(std::size_t k, const scene::Color& c)
    {
        PlainHit& plain = scratch_.plain[k];
        plain.pigment = c;
        plain.alpha = plain.goes_on ? texture::opacity(c, context_.scene.textures.legacy_opacity) : 1.0f;
        plain.glow = c.rgb() * (plain.finish->ambient + plain.finish->emission) * plain.alpha;
        plain.lit = glm::vec3(0);
    }

    void surround(int i)
    {
        const auto k = static_cast<std::size_t>(i);
        const HitDetails& at = details(i);
        scratch_.around[k] = {at.point, scratch_.hits.normal(k), rays_.ray(i).direction, at.uv, true};
    }

    glm::dvec3 pattern_point(int i, const Hit& hit)
    {
        const HitDetails& at = details(i);
        return context_.scene.surfaces[hit.surface].uv_mapping ? glm::dvec3(at.uv.x, at.uv.y, 0.0) : at.point;
    }

    void begin_layers(int i, const Hit& hit, std::uint32_t texture)
    {
        if (texture == plan::kNone) return;
        LayersAhead& layers = scratch_.layers[static_cast<std::size_t>(i)];
        layers.texture = texture;
        layers.residual = 1.0f;
        layers.filter = glm::vec3(1);
        layers.point = pattern_point(i, hit);
        surround(i);
    }

    bool asks_for_light(int i) const
    {
        const texture::Finish* finish = scratch_.plain[static_cast<std::size_t>(i)].finish;
        if (finish != nullptr) return finish->lit();
        const Hit hit = hits_.at(i);
        if (!hit.found()) return false;
        const std::uint32_t texture = context_.scene.surfaces[hit.surface].texture;
        return texture != plan::kNone && context_.scene.textures.textures[texture].lit;
    }

    /// Adds the light at once where nothing can shadow it; a shadow ray otherwise.
    void ask(const light::Light& light, std::size_t which, int i, bool shadows)
    {
        const auto k = static_cast<std::size_t>(i);
        const bool plain = scratch_.plain[k].finish != nullptr;
        const glm::dvec3 direction = scratch_.light.direction(k);
        const double distance = scratch_.light.distance[k], end = distance - kShadowTolerance;
        const glm::vec3& color = scratch_.lit_colors[k];
        if (!plain) {
            LightSample& s = sample(i, which);
            s.lit = {direction, distance, color};
            s.illuminated = true;
        }
        // Bent normals may face a light that the surface turns away from: rare, asked for one by one.
        if (glm::dot(scratch_.hits.normal(k), direction) < kNearlyZero) return;
        if (color == glm::vec3(0)) return;
        if (!shadows || end <= kShadowTolerance) {
            if (plain) add(light, k, color);
            return;
        }
        RayTile& beam = scratch_.rays;
        const auto ray = static_cast<std::size_t>(beam.count++);
        const glm::dvec3 origin = beam.common_origin ? light.location : scratch_.hits.point(k);
        const glm::dvec3 along = beam.common_origin ? -direction : direction;
        beam.ox[ray] = origin.x;
        beam.oy[ray] = origin.y;
        beam.oz[ray] = origin.z;
        beam.dx[ray] = along.x;
        beam.dy[ray] = along.y;
        beam.dz[ray] = along.z;
        beam.t_min[ray] = kShadowTolerance;
        beam.t_max[ray] = end;
        scratch_.lane[ray] = static_cast<std::uint8_t>(i);
    }

    void answer(const light::Light& light, std::size_t which)
    {
        const RayTile& beam = scratch_.rays;
        csg::CrossingTile& met = scratch_.crossings;
        context_.scratch.counts.shadow += static_cast<std::uint64_t>(beam.count);
        if (scratch_.traits.filters)
            context_.world.shadow_crossings(beam, context_.scratch.geometry, met);
        else
            context_.world.shadow(beam, context_.scratch.geometry, met.ending.data());
        for (std::size_t ray = 0; ray < static_cast<std::size_t>(beam.count); ++ray) {
            const std::size_t k = scratch_.lane[ray];
            const bool plain = scratch_.plain[k].finish != nullptr;
            if (plain && met.ending[ray] == Shadow::Blocked) continue;
            const glm::vec3 color = met.ending[ray] == Shadow::Clear     ? scratch_.lit_colors[k]
                                    : met.ending[ray] == Shadow::Blocked ? glm::vec3(0)
                                                                         : filtered(ray, k);
            if (plain) {
                add(light, k, color);
            } else {
                LightSample& s = sample(static_cast<int>(k), which);
                s.shadowed = color;
                s.shadow_known = true;
            }
        }
    }

    /// The light at hand past what a shadow ray crosses.
    glm::vec3 filtered(std::size_t ray, std::size_t k)
    {
        const light::Illumination lit{scratch_.light.direction(k), scratch_.light.distance[k], scratch_.lit_colors[k]};
        const std::uint8_t count = scratch_.crossings.count[ray];
        if (count == csg::CrossingTile::kTooMany) return filtered_light(context_, scratch_.hits.point(k), interiors(k), lit, lit.color);
        return crossed_light(context_, scratch_.hits.point(k), interiors(k), lit, scratch_.rays.common_origin,
                             scratch_.crossings.hits[ray].data(), count);
    }

    void add(const light::Light& light, std::size_t k, const glm::vec3& color)
    {
        if (!(std::abs(color.x) > kDark || std::abs(color.y) > kDark || std::abs(color.z) > kDark)) return;
        PlainHit& plain = scratch_.plain[k];
        const glm::dvec3 d{rays_.dx[k], rays_.dy[k], rays_.dz[k]}, n = scratch_.hits.normal(k);
        plain.lit += surface_light({*plain.finish, plain.pigment, d, n, static_cast<double>(plain.alpha)}, scratch_.light.direction(k), color, false,
                                   !light.shadowless, 0.0);
    }

    Context& context_;
    ShadeScratch& scratch_;
    const RayTile& rays_;
    const HitTile& hits_;
    const RayState& camera_;
    const WaitingRay* waiting_;
    std::size_t lights_, base_ = 0;
    bool shadows_;
};

}  // namespace trace
