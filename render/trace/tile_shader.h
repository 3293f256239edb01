#pragma once

#include "csg/lane_equal.h"
#include "csg/reach.h"
#include "render/trace/area_light.h"
#include "render/trace/flat_hits.h"
#include "render/trace/look_ahead.h"
#include "render/trace/shade_context.h"
#include "render/trace/shadow_rays.h"
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
    /// waiting: what the rays inherit; none for camera rays, which share `camera` but for its interiors where there are `starts`.
    TileShader(Context& context, const RayTile& rays, const HitTile& hits, const RayState& camera, const InteriorList* starts, const WaitingRay* waiting)
        : context_(context), scratch_(context.scratch.shade), flat_(context), rays_(rays), hits_(hits), camera_(camera), starts_(starts), waiting_(waiting),
          lights_(context.scene.lights.lights.size()), shadows_(context.scene.settings.quality >= 4)
    {
    }

    /// Places and what is to be done with each hit; true if some are not flat and need LightSamples.
    bool prepare()
    {
        const plan::Settings& settings = context_.scene.settings;
        small_ = settings.quality >= 2;
        go_on_ = settings.quality >= 8 && settings.adc_bailout < 1.0 && !scratch_.wave.full();
        find_places();
        scratch_.pigments.clear();
        scratch_.layered_count = 0;
        for (HitMask left = found_; left != 0;) {
            const csg::SurfaceId surface = hits_.surface[first_hit(left)];
            const HitMask group = left & csg::lanes::equal(hits_.surface, surface);
            const SurfaceTraits& traits = scratch_.traits.surfaces[surface];
            begin(group & ~inside_, surface, traits.outer, traits.outer_layers);
            begin(group & inside_, surface, traits.inner, traits.inner_layers);
            left &= ~group;
        }
        scratch_.pigments.run(context_.scene.textures, [this](HitMask hits, const texture::ColorPoints& colors) { flat_.color(hits, colors); });
        if (general_) finish_layers();
        flat_.bend();
        asks_ = flat_.lit();
        if (general_) for_each_hit(found_ & ~flat_.all(), [this](std::size_t k) {
            if (lit(k)) asks_ |= HitMask{1} << k;
        });
        return general_;
    }

    /// Where the tile's LightSamples start in the scratch stack.
    void use_samples(std::size_t base) { base_ = base; }

    /// One light for the whole tile: it is added to flat hits, and waits in the LightSamples of the others.
    void light(std::size_t which)
    {
        const light::Light& light = context_.scene.lights.lights[which];
        const HitMask asks = asks_;
        if (scratch_.traits.grouped) asks_ &= shone_on(light);
        if (asks_ != 0) add(which, light);
        asks_ = asks;
    }

    /// All lights are through.
    void finish() { flat_.finish(); }

    void color(int i)
    {
        const auto k = static_cast<std::size_t>(i);
        const bool done = flat_.done(k);
        if (done && !foggy(context_)) {
            give(i, scene::Color::of(flat_.sum(k)));
            return;
        }
        const Hit hit = hits_.at(i);
        RayState own;
        if (waiting_ == nullptr) {
            own = camera_;
            own.ray = rays_.ray(i);
            if (starts_ != nullptr) own.interiors = starts_[i];
        }
        const RayState& state = waiting_ == nullptr ? own : waiting_[k].state;
        if (!hit.found()) {
            give(i, through_air(context_, state, csg::kInfinity, sky_color(context_, state)));
        } else if (done) {
            give(i, through_air(context_, state, hit.t, scene::Color::of(flat_.sum(k))));
        } else if (flat_.holds(k)) {
            const HitPlace place{state, hit, context_.scene.surfaces[hit.surface], scratch_.hits.point(k), scratch_.hits.normal(k), level(i), has(inside_, k)};
            add_branch(context_, place, flat_.top_finish(k), flat_.top_pigment(k), flat_.sum(k), place_of(i), reach(i) + hit.t);
        } else {
            LayersAhead ahead;
            const bool known = layers_ahead(k, ahead);
            give(i, through_air(context_, state, hit.t, shade_hit(context_, state, hit, details(k), level(i), first_light(i), known ? &ahead : nullptr)));
        }
    }

private:
    /// A light is added to the hits of asks_.
    void add(std::size_t which, const light::Light& light)
    {
        const HitMask colored = steady(light) ? illuminate_from_point(light) : illuminate_each(light);
        for_each_hit(asks_ & ~flat_.all(), [&](std::size_t k) {
            LightSample& s = sample(static_cast<int>(k), which);
            s.lit = {scratch_.light.direction(k), scratch_.light.distance[k], scratch_.lit_colors[k]};
            s.illuminated = true;
        });
        const bool shadows = shadows_ && (!light.shadowless || light.projector);
        if (light.area && (shadows || light.area_illumination)) {
            const HitMask asking = light.area_illumination ? asks_ : asks_ & colored & facing();
            if (asking != 0) add_area(which, light, asking, shadows);
            return;
        }
        HitMask asking = asks_ & colored & facing();
        if (shadows) {
            if (light.projector) asking &= project(which, light, asking);
            const HitMask near = light.shadowless ? asking : find_shadow_ends(context_.scene.tolerance.shadow, scratch_.hits, hits_, scratch_.light, scratch_.shadow_ends, rays_.count);
            flat_.light(asking & near & flat_.all());
            for_each_hit(asking & near & ~flat_.all(), [&](std::size_t k) { know(k, which, scratch_.lit_colors[k]); });
            asking &= ~near;
            if (asking != 0) {
                const bool from_light = light.from_one_point() && !scratch_.traits.beside && !context_.scene.geometry.faithful && (asks_ & beyond(scratch_.light, kFarLight * context_.scene.tolerance.shadow, rays_.count)) == 0;
                answer(which, light, shadow_rays(scratch_, asking, from_light ? &light.location : nullptr));
            }
        } else {
            flat_.light(asking & flat_.all());
        }
        flat_.add(light, rays_);
    }

    /// The hits that see a light through its projector, where their shadow rays end then; the others are dark.
    HitMask project(std::size_t which, const light::Light& light, HitMask asking)
    {
        HitMask seen = 0;
        for_each_hit(asking, [&](std::size_t k) {
            const double depth = light.projector->depth({scratch_.hits.point(k), scratch_.light.direction(k)});
            if (depth < 0.0 || depth >= scratch_.light.distance[k]) {
                if (!flat_.holds(k)) know(k, which, glm::vec3(0));
                return;
            }
            scratch_.light.distance[k] = depth;
            seen |= HitMask{1} << k;
        });
        return seen;
    }

    /// The same of an area light, whose shadows are found for all hits at once.
    void add_area(std::size_t which, const light::Light& light, HitMask asking, bool shadows)
    {
        TileColors& seen = scratch_.area_colors;
        if (shadows) {
            std::array<const InteriorList*, csg::kTileRays> around;
            for_each_hit(asking, [&](std::size_t k) { around[k] = &interiors(k); });
            AreaLight(context_, light, hits_, around.data()).shadows(asking, seen);
            if (light.atmosphere && !light.shadowless)   // as if all of it came from the centre
                for_each_hit(asking, [&](std::size_t k) {
                    if (!interiors(k).all_hollow(context_.scene.interiors)) return;
                    seen.set(k, seen[k] * fog_share(context_, {scratch_.hits.point(k), scratch_.light.direction(k)}, scratch_.light.distance[k]));
                });
            for_each_hit(asking & ~flat_.all(), [&](std::size_t k) { know(k, which, seen[k]); });
        } else {
            for_each_hit(asking, [&](std::size_t k) { seen.set(k, light.color); });
        }
        asking &= flat_.all();
        if (light.area_illumination) return add_nodes(light, asking, seen);
        for_each_hit(asking, [&](std::size_t k) { flat_.light(k, seen[k]); });
        flat_.add(light, rays_);
    }

    /// area_illumination: every node is a light of its own under one common shadow (spec 3, 12.7).
    void add_nodes(const light::Light& light, HitMask asking, const TileColors& seen)
    {
        HitMask reached = 0;
        for_each_hit(asking, [&](std::size_t k) { reached |= black_or_darker(seen[k]) ? 0 : HitMask{1} << k; });
        if (reached == 0) return;
        const float share = 1.0f / static_cast<float>(light.size1 * light.size2);
        flat_.begin_group();
        for (int j = 0; j < light.size2; ++j)
            for (int i = 0; i < light.size1; ++i) {
                for_each_hit(reached, [&](std::size_t k) {
                    const glm::dvec3 point = scratch_.hits.point(k);
                    const light::Illumination lit = light::illuminate(light, point, light::node_offset(light, point, i, j));
                    scratch_.light.x[k] = lit.direction.x;
                    scratch_.light.y[k] = lit.direction.y;
                    scratch_.light.z[k] = lit.direction.z;
                    glm::vec3 color = seen[k] * share;
                    for (int c = 0; c < 3; ++c)
                        if (light.color[c] != 0.0f) color[c] *= lit.color[c] / light.color[c];
                    flat_.begin_light(k, color);
                });
                flat_.light(reached & facing());
                flat_.add(light, rays_);
            }
        flat_.end_group();
    }

    static bool black_or_darker(const glm::vec3& c) { return !(std::abs(c.x) > kDark || std::abs(c.y) > kDark || std::abs(c.z) > kDark); }

    int level(int i) const { return waiting_ == nullptr ? 1 : waiting_[i].level; }
    double reach(int i) const { return waiting_ == nullptr ? 0.0 : waiting_[i].reach; }
    Place place_of(int i) const { return waiting_ == nullptr ? static_cast<Place>(i) : waiting_[i].place; }
    const InteriorList& interiors(std::size_t k) const
    {
        return waiting_ != nullptr ? waiting_[k].state.interiors : starts_ != nullptr ? starts_[k] : camera_.interiors;
    }
    void give(int i, const scene::Color& c) { scratch_.wave.colors[place_of(i)] = c; }

    std::size_t first_light(int i) const { return base_ + static_cast<std::size_t>(i) * lights_; }
    LightSample& sample(int i, std::size_t which) { return scratch_.lights[first_light(i) + which]; }

    /// Points and normals that face the viewer.
    void find_places()
    {
        TileHits& places = scratch_.hits;
        const HitMask all = first_hits(rays_.count);
        found_ = all & ~csg::lanes::equal(hits_.surface, csg::kNoSurface);
        count_far();
        batched_ = found_;
        if (!scratch_.traits.all_batched)
            for_each_hit(found_, [&](std::size_t k) {
                if (!scratch_.traits.surfaces[hits_.surface[k]].batched) batched_ &= ~(HitMask{1} << k);
            });
        context_.world.places(rays_, hits_, batched_, places);
        for_each_hit(found_ & ~batched_, [&](std::size_t k) {
            // Made in place: a copy of what was just written in smaller pieces waits for all of them.
            const auto i = static_cast<int>(k);
            const HitDetails& at = *new (&scratch_.details[k]) HitDetails(hit_details(context_, rays_.ray(i), hits_.at(i)));
            places.set(k, at.point, at.normal);
        });
        const HitMask lanes = first_hits((rays_.count + csg::kTileSide - 1) / csg::kTileSide * csg::kTileSide);
        for_each_hit(lanes & ~found_, [&](std::size_t k) { places.set(k, glm::dvec3(0), glm::dvec3(0)); });
        inside_ = found_ & turn_to_viewer(rays_, places);
    }

    /// Hits that POV-Ray does not tell of, for a word to the user.
    void count_far()
    {
        using csg::lanes::Double;
        HitMask far = 0;
        for (int i = 0; i < rays_.count; i += csg::lanes::kDoubles)
            far |= HitMask{csg::lanes::mask(Double::load_aligned(hits_.t.data() + i) > Double(csg::Reach::kFar))} << i;
        far &= found_;
        for_each_hit(far, [&](std::size_t k) { context_.scratch.counts.far += context_.world.too_far(hits_.at(static_cast<int>(k))) ? 1 : 0; });
    }

    /// What World::details says of hit k.
    const HitDetails& details(std::size_t k)
    {
        HitDetails& at = scratch_.details[k];
        if (has(batched_, k)) {
            const glm::dvec3 n = scratch_.hits.normal(k);
            at = {scratch_.hits.point(k), has(inside_, k) ? -n : n};
        }
        return at;
    }

    /// Pigments of hit k that were looked up together with others'.
    bool layers_ahead(std::size_t k, LayersAhead& out) const
    {
        if (!has(ahead_, k)) return false;
        for (std::size_t g = 0; g < scratch_.layered_count; ++g) {
            const LayeredGroup& group = scratch_.layered[g];
            if (has(group.hits, k)) out = {group.texture, context_.scene.textures.textures[group.texture].count, &scratch_.ahead, k};
        }
        return true;
    }

    /// Hits on one side of a surface.
    void begin(HitMask group, csg::SurfaceId surface, const LoneLayer& lone, const AheadLayers& layers)
    {
        if (group == 0) return;
        if (small_ && lone.index != plan::kNone && (go_on_ || !lone.goes_on)) {
            begin_lone(group, surface, lone);
            return;
        }
        general_ = true;
        if (layers.texture != plan::kNone) begin_layers(group, surface, layers);
    }

    void begin_lone(HitMask group, csg::SurfaceId surface, const LoneLayer& lone)
    {
        const auto& set = context_.scene.textures;
        flat_.begin(group, lone);
        const std::uint32_t index = set.layers[lone.index].pigment;
        const texture::Pigment& pigment = set.pigments[index];
        const bool solid = pigment.kind == texture::Pigment::Kind::Solid;
        if (solid) {
            scratch_.solid.fill(pigment.color);
            flat_.color(group, scratch_.solid);
        }
        if (solid && !flat_.bent(first_hit(group))) return;
        surround(group, surface);
        if (!solid) scratch_.pigments.ask(group, index, scratch_.points, scratch_.around);
    }

    /// Pigments of the layers, top down; hits whose layers hide what is behind them are flat then.
    void finish_layers()
    {
        const auto& set = context_.scene.textures;
        const auto bailout = static_cast<float>(context_.scene.settings.adc_bailout);
        const HitMask open = look_ahead(scratch_, set, bailout);
        for (std::size_t g = 0; g < scratch_.layered_count; ++g) {
            const LayeredGroup& group = scratch_.layered[g];
            if (group.flat && (group.hits & ~open) != 0) flat_.begin(group.hits & ~open, set.textures[group.texture]);
        }
        general_ = (found_ & ~flat_.all()) != 0;
    }

    /// The hits as patterns see them.
    void surround(HitMask group, csg::SurfaceId surface)
    {
        const TileHits& places = scratch_.hits;
        const bool uv = context_.scene.surfaces[surface].uv_mapping;
        for_each_hit(group, [&](std::size_t k) { scratch_.points.set(k, uv ? glm::dvec3(scratch_.details[k].uv, 0.0) : places.point(k)); });
        if (!scratch_.traits.looked_around) return;
        for_each_hit(group, [&](std::size_t k) {
            texture::Surroundings& around = scratch_.around[k];   // member by member, as the details
            around.point = places.point(k);
            around.normal = places.normal(k);
            around.direction = rays_.ray(static_cast<int>(k)).direction;
            around.uv = has(batched_, k) ? glm::dvec2(0) : scratch_.details[k].uv;
            around.surface = true;
        });
    }

    void begin_layers(HitMask group, csg::SurfaceId surface, const AheadLayers& of)
    {
        ahead_ |= group;
        scratch_.layered[scratch_.layered_count++] = {group, of.texture, of.flat && small_};
        surround(group, surface);
    }

    /// Hits that the light's group lets it shine on.
    HitMask shone_on(const light::Light& light) const
    {
        HitMask on = 0;
        for_each_hit(asks_, [&](std::size_t k) {
            if (shines_on(light, context_.scene.surfaces[hits_.surface[k]])) on |= HitMask{1} << k;
        });
        return on;
    }

    /// Some texture of the hit is lit.
    bool lit(std::size_t k) const
    {
        const std::uint32_t texture = context_.scene.surfaces[hits_.surface[k]].texture;
        return texture != plan::kNone && context_.scene.textures.textures[texture].lit;
    }

    /// Directions, distances and colours of a light at one point; the hits where it has a colour.
    HitMask illuminate_from_point(const light::Light& light)
    {
        toward_point(light, scratch_.hits, rays_.count, scratch_.light);
        scratch_.lit_colors.fill(light.color);
        flat_.begin_light(light.color);
        return light.color == glm::vec3(0) ? 0 : ~HitMask{0};
    }

    /// The same of any light.
    HitMask illuminate_each(const light::Light& light)
    {
        HitMask colored = 0;
        for_each_hit(asks_, [&](std::size_t k) {
            const light::Illumination lit = light::illuminate(light, scratch_.hits.point(k));
            scratch_.light.x[k] = lit.direction.x;
            scratch_.light.y[k] = lit.direction.y;
            scratch_.light.z[k] = lit.direction.z;
            scratch_.light.distance[k] = lit.distance;
            scratch_.lit_colors[k] = lit.color;
            flat_.begin_light(k, lit.color);
            if (lit.color != glm::vec3(0)) colored |= HitMask{1} << k;
        });
        return colored;
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

    /// What the shadow rays tell. `in_order`: ray i is hit i's.
    void answer(std::size_t which, const light::Light& light, bool in_order)
    {
        const RayTile& beam = scratch_.rays;
        csg::CrossingTile& met = scratch_.crossings;
        context_.scratch.counts.shadow += static_cast<std::uint64_t>(beam.count);
        if (scratch_.traits.filters)
            context_.world.shadow_crossings(beam, context_.scratch.geometry, met);
        else
            context_.world.shadow(beam, context_.scratch.geometry, met.ending.data());
        const auto hit_of = [&](std::size_t ray) { return in_order ? ray : scratch_.lane[ray]; };
        const HitMask rays = first_hits(beam.count), blocked = rays & equal(met.ending, Shadow::Blocked);
        const HitMask clear = light.atmosphere ? 0 : rays & equal(met.ending, Shadow::Clear);   // fog dims all of them
        HitMask reached = clear;
        if (!in_order) {
            reached = 0;
            for_each_hit(clear, [&](std::size_t ray) { reached |= HitMask{1} << hit_of(ray); });
        }
        flat_.light(reached & flat_.all());
        for_each_hit(rays & ~clear & ~blocked, [&](std::size_t ray) {
            const std::size_t k = hit_of(ray);
            const glm::vec3 color = filtered(ray, k, light.atmosphere);
            if (flat_.holds(k)) flat_.light(k, color);
            else know(k, which, color);
        });
        if (!general_) return;
        for_each_hit(clear | blocked, [&](std::size_t ray) {
            const std::size_t k = hit_of(ray);
            if (!flat_.holds(k)) know(k, which, has(clear, ray) ? scratch_.lit_colors[k] : glm::vec3(0));
        });
    }

    static HitMask equal(const std::array<Shadow, csg::kTileRays>& endings, Shadow to)
    {
        return csg::lanes::equal(reinterpret_cast<const std::uint8_t*>(endings.data()), static_cast<std::uint8_t>(to));
    }

    void know(std::size_t k, std::size_t which, const glm::vec3& shadowed)
    {
        LightSample& s = sample(static_cast<int>(k), which);
        s.shadowed = shadowed;
        s.shadow_known = true;
    }

    /// The light at hand past what a shadow ray crosses, and fog if it dims light.
    glm::vec3 filtered(std::size_t ray, std::size_t k, bool in_fog)
    {
        const light::Illumination lit{scratch_.light.direction(k), scratch_.light.distance[k], scratch_.lit_colors[k]};
        const bool clear = scratch_.crossings.ending[ray] == Shadow::Clear;
        const std::uint8_t count = clear ? 0 : scratch_.crossings.count[ray];
        const bool too_many = count == csg::CrossingTile::kTooMany;
        if (too_many || (scratch_.traits.restarts() && !clear))
            return filtered_light(context_, scratch_.hits.point(k), scratch_.shadow_ends.from[k], interiors(k), lit, lit.color, in_fog,
                                  too_many ? nullptr : scratch_.crossings.hits[ray].data());
        return crossed_light(context_, scratch_.hits.point(k), scratch_.shadow_ends.from[k], interiors(k), lit, scratch_.rays.common_origin,
                             scratch_.crossings.hits[ray].data(), count, in_fog);
    }

    Context& context_;
    ShadeScratch& scratch_;
    FlatHits flat_;
    const RayTile& rays_;
    const HitTile& hits_;
    const RayState& camera_;
    const InteriorList* starts_;
    const WaitingRay* waiting_;
    std::size_t lights_, base_ = 0;
    bool shadows_, small_ = false, go_on_ = false;
    bool general_ = false;   ///< some hits are not flat
    HitMask found_ = 0, batched_ = 0, inside_ = 0;   ///< hits; of them, those without details of their own; those whose normal was turned
    HitMask ahead_ = 0;      ///< hits that have LayersAhead
    HitMask asks_ = 0;       ///< hits that light changes
};

}  // namespace trace
