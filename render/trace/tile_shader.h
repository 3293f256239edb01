#pragma once

#include "render/trace/flat_hits.h"
#include "render/trace/look_ahead.h"
#include "render/trace/shade_context.h"
#include "render/trace/wave.h"

#include <algorithm>

/// Shading of one tile's hits. Compiled once per instruction set.
namespace trace {

/// Beyond so many tolerances, 1e5 as a rule, a shadow ray starts at the hit: from a far light, t would lose digits against one.
inline constexpr double kFarLight = 1e8;

/// Lit from one point with one colour everywhere: its directions are found in vector lanes.
inline bool steady(const light::Light& light)
{
    return light.kind == light::Light::Kind::Point && !light.parallel && !light.area && !(light.fade_power > 0.0);
}

/// One tile of rays on its way to colours. Flat hits go through the lights together and are done then, but for the rays that
/// go on from them; the others find their first shadow rays answered and are shaded one by one.
class TileShader {
public:
    /// waiting: what the rays inherit; none for camera rays, which share `camera`.
    TileShader(Context& context, const RayTile& rays, const HitTile& hits, const RayState& camera, const WaitingRay* waiting)
        : context_(context), scratch_(context.scratch.shade), flat_(context), rays_(rays), hits_(hits), camera_(camera), waiting_(waiting),
          lights_(context.scene.lights.lights.size()), shadows_(context.scene.settings.quality >= 4)
    {
    }

    /// Details and what is to be done with each hit; true if some are not flat and need LightSamples.
    bool prepare()
    {
        const auto& lights = context_.scene.lights.lights;
        const plan::Settings& settings = context_.scene.settings;
        const bool small = settings.quality >= 2 &&
                           std::none_of(lights.begin(), lights.end(), [](const light::Light& l) { return l.by_points(); });
        const bool go_on = settings.quality >= 8 && settings.adc_bailout < 1.0 && !scratch_.wave.full();
        bool ahead = false;
        PigmentBatch& pigments = scratch_.pigments;
        pigments.clear();
        for (int i = 0; i < rays_.count; ++i) {
            const auto k = static_cast<std::size_t>(i);
            scratch_.layers[k].texture = plan::kNone;
            const Hit hit = hits_.at(i);
            if (!hit.found()) {
                scratch_.hits.set(k, glm::dvec3(0), glm::dvec3(0));
                continue;
            }
            const csg::Ray ray = rays_.ray(i);
            // Made in place: a copy of what was just written in smaller pieces waits for all of them.
            const HitDetails& at = *new (&details(i)) HitDetails(hit_details(context_, ray, hit));
            const bool from_inside = glm::dot(at.normal, ray.direction) > 0.0;
            scratch_.hits.set(k, at.point, from_inside ? -at.normal : at.normal);
            const SurfaceTraits& traits = scratch_.traits.surfaces[hit.surface];
            const LoneLayer& layer = from_inside ? traits.inner : traits.outer;
            if (small && layer.index != plan::kNone && (go_on || !layer.goes_on)) {
                begin_lone(i, layer, hit);
            } else {
                general_ = ahead = true;
                begin_layers(i, hit, from_inside ? traits.inner_layers : traits.outer_layers, small);
            }
        }
        pigments.run(context_.scene.textures, [this](std::size_t k, const scene::Color& c) { flat_.color(k, c); });
        if (ahead) finish_layers();
        for (int i = rays_.count; i % csg::kTileSide != 0; ++i)
            scratch_.hits.set(static_cast<std::size_t>(i), glm::dvec3(0), glm::dvec3(0));
        flat_.bend();
        asks_ = flat_.lit();
        for (int i = 0; general_ && i < rays_.count; ++i)
            if (asks_for_light(i)) asks_ |= HitMask{1} << i;
        return general_;
    }

    /// Where the tile's LightSamples start in the scratch stack.
    void use_samples(std::size_t base) { base_ = base; }

    /// One light for the whole tile: it is added to flat hits, and waits in the LightSamples of the others.
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
        for_each_hit(asks_, [&](std::size_t k) {
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
            if (!(scratch_.light.distance[k] < kFarLight * context_.scene.tolerance.shadow)) beam.common_origin = false;
        });
        const HitMask toward = facing();
        for_each_hit(asks_, [&](std::size_t k) { ask(which, k, (toward >> k & 1) != 0, shadows, light.location); });
        if (beam.count != 0) answer(which);
        flat_.add(light, rays_);
    }

    /// All lights are through.
    void finish() { flat_.finish(); }

    void color(int i)
    {
        const Hit hit = hits_.at(i);
        const auto k = static_cast<std::size_t>(i);
        const bool done = flat_.done(k);
        if (done && !foggy(context_)) {
            give(i, scene::Color::of(flat_.sum(k)));
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
            give(i, through_air(context_, state, hit.t, scene::Color::of(flat_.sum(k))));
        } else if (flat_.holds(k)) {
            const HitPlace place{state, hit, context_.scene.surfaces[hit.surface], scratch_.hits.point(k), scratch_.hits.normal(k), level(i),
                                 glm::dot(details(i).normal, state.ray.direction) > 0.0};
            add_branch(context_, place, flat_.top_finish(k), flat_.top_pigment(k), flat_.sum(k), place_of(i), reach(i) + hit.t);
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

    void begin_lone(int i, const LoneLayer& lone, const Hit& hit)
    {
        const auto k = static_cast<std::size_t>(i);
        const auto& set = context_.scene.textures;
        flat_.begin(k, lone);
        const std::uint32_t index = set.layers[lone.index].pigment;
        const texture::Pigment& pigment = set.pigments[index];
        const bool solid = pigment.kind == texture::Pigment::Kind::Solid;
        if (solid) flat_.color(k, pigment.color);
        if (solid && !flat_.bent(k)) return;
        surround(i, hit);
        if (!solid) scratch_.pigments.ask(k, index, scratch_.points[k], scratch_.around[k]);
    }

    /// Pigments of the layers, top down; hits whose layers hide what is behind them are flat then.
    void finish_layers()
    {
        const auto& set = context_.scene.textures;
        const auto bailout = static_cast<float>(context_.scene.settings.adc_bailout);
        look_ahead(scratch_, set, rays_.count, bailout);
        general_ = false;
        for (std::size_t k = 0; k < static_cast<std::size_t>(rays_.count); ++k) {
            if (flat_.holds(k) || !hits_.at(static_cast<int>(k)).found()) continue;
            const LayersAhead& layers = scratch_.layers[k];
            if (layers.texture != plan::kNone && layers.flat && !(layers.residual > bailout))
                flat_.begin(k, set.textures[layers.texture], layers.colors);
            else
                general_ = true;
        }
    }

    /// The hit as patterns see it.
    void surround(int i, const Hit& hit)
    {
        const auto k = static_cast<std::size_t>(i);
        const HitDetails& at = details(i);
        scratch_.points[k] = context_.scene.surfaces[hit.surface].uv_mapping ? glm::dvec3(at.uv.x, at.uv.y, 0.0) : at.point;
        texture::Surroundings& around = scratch_.around[k];   // member by member, as the details
        around.point = at.point;
        around.normal = scratch_.hits.normal(k);
        around.direction = rays_.ray(i).direction;
        around.uv = at.uv;
        around.surface = true;
    }

    void begin_layers(int i, const Hit& hit, const AheadLayers& of, bool small)
    {
        if (of.texture == plan::kNone) return;
        LayersAhead& layers = scratch_.layers[static_cast<std::size_t>(i)];
        layers.texture = of.texture;
        layers.flat = of.flat && small;
        layers.residual = 1.0f;
        layers.filter = glm::vec3(1);
        surround(i, hit);
    }

    /// Of a hit that is not flat.
    bool asks_for_light(int i) const
    {
        if (flat_.holds(static_cast<std::size_t>(i))) return false;
        const Hit hit = hits_.at(i);
        if (!hit.found()) return false;
        const std::uint32_t texture = context_.scene.surfaces[hit.surface].texture;
        return texture != plan::kNone && context_.scene.textures.textures[texture].lit;
    }

    /// Hits that face the light at hand. Others' bent normals may face a light that the surface turns away from: rare, asked
    /// for one by one.
    HitMask facing() const
    {
        using csg::lanes::Double;
        HitMask away = 0;
        for (int i = 0; i < rays_.count; i += csg::lanes::kDoubles) {
            const auto get = [i](const TileLanes& lanes) { return Double::load_aligned(lanes.data() + i); };
            const Double cosine = get(scratch_.hits.nx) * get(scratch_.light.x) + get(scratch_.hits.ny) * get(scratch_.light.y) +
                                  get(scratch_.hits.nz) * get(scratch_.light.z);
            away |= HitMask{csg::lanes::mask(cosine < Double(kNearlyZero))} << i;
        }
        HitMask toward = ~away;
        for_each_hit(flat_.all_bent(), [&](std::size_t k) {
            const HitMask bit = HitMask{1} << k;
            toward = flat_.faces(k, scratch_.light.direction(k)) ? toward | bit : toward & ~bit;
        });
        return toward;
    }

    double shadow_tolerance(std::size_t k) const { return context_.scene.tolerance.shadow_from(scratch_.hits.point(k), hits_.t[k]); }

    /// Adds the light at once where nothing can shadow it; a shadow ray otherwise.
    void ask(std::size_t which, std::size_t k, bool toward, bool shadows, const glm::dvec3& lamp)
    {
        const glm::dvec3 direction = scratch_.light.direction(k);
        const double distance = scratch_.light.distance[k], tolerance = shadow_tolerance(k), end = distance - tolerance;
        const glm::vec3& color = scratch_.lit_colors[k];
        if (!flat_.holds(k)) {
            LightSample& s = sample(static_cast<int>(k), which);
            s.lit = {direction, distance, color};
            s.illuminated = true;
        }
        if (!toward) return;
        if (color == glm::vec3(0)) return;
        if (!shadows || end <= tolerance) {
            if (flat_.holds(k)) flat_.light(k, color);
            return;
        }
        RayTile& beam = scratch_.rays;
        const auto ray = static_cast<std::size_t>(beam.count++);
        const glm::dvec3 origin = beam.common_origin ? lamp : scratch_.hits.point(k);
        const glm::dvec3 along = beam.common_origin ? -direction : direction;
        beam.ox[ray] = origin.x;
        beam.oy[ray] = origin.y;
        beam.oz[ray] = origin.z;
        beam.dx[ray] = along.x;
        beam.dy[ray] = along.y;
        beam.dz[ray] = along.z;
        beam.t_min[ray] = tolerance;
        beam.t_max[ray] = end;
        scratch_.lane[ray] = static_cast<std::uint8_t>(k);
    }

    void answer(std::size_t which)
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
            if (flat_.holds(k) && met.ending[ray] == Shadow::Blocked) continue;
            const glm::vec3 color = met.ending[ray] == Shadow::Clear     ? scratch_.lit_colors[k]
                                    : met.ending[ray] == Shadow::Blocked ? glm::vec3(0)
                                                                         : filtered(ray, k);
            if (flat_.holds(k)) {
                flat_.light(k, color);
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
        if (count == csg::CrossingTile::kTooMany) return filtered_light(context_, scratch_.hits.point(k), shadow_tolerance(k), interiors(k), lit, lit.color);
        return crossed_light(context_, scratch_.hits.point(k), shadow_tolerance(k), interiors(k), lit, scratch_.rays.common_origin,
                             scratch_.crossings.hits[ray].data(), count);
    }

    Context& context_;
    ShadeScratch& scratch_;
    FlatHits flat_;
    const RayTile& rays_;
    const HitTile& hits_;
    const RayState& camera_;
    const WaitingRay* waiting_;
    std::size_t lights_, base_ = 0;
    bool shadows_;
    bool general_ = false;   ///< some hits are not flat
    HitMask asks_ = 0;       ///< hits that light changes
};

}  // namespace trace
