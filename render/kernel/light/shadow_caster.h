#pragma once

#include "render/kernel/context/projected.h"
#include "render/kernel/light/area_light.h"
#include "render/kernel/light/surface_filters.h"
#include "render/kernel/extinction/shadow_media.h"
#include "render/kernel/light/restarted_rays.h"
#include "render/kernel/light/shadow_filter.h"
#include "render/kernel/light/shadow_rays.h"
#include "render/kernel/record/recorder.h"

#include <algorithm>
#include <limits>

/// What stands between the points of a tile and a light: the same for hits of surfaces and for points of the air.
namespace trace {

/// Beyond so many tolerances, 1e5 as a rule, a shadow ray starts at the hit: from a far light, t would lose digits
/// against one.
inline constexpr double kFarLight = 1e8;

/// Lit from one point with one colour everywhere: its directions are found in vector lanes.
inline bool steady(const light::Light& light)
{
    return light.kind == light::Light::Kind::Point && !light.parallel && !light.area && !(light.fade_power > 0.0);
}

/// The points lie in ShadeScratch::hits, the light at hand as they see it in ShadeScratch::light and lit_colors.
/// \tparam Tile  count(), hits.t: how far the rays came that found the points, interiors(k): what point k is inside of;
///               kInAir: the points lie on no surface, as a rule
/// \tparam Sink  receives what arrives: light(hits): all of lit_colors; light(k, colour), and arrive(k, colour) for
///               what light() is not told of; arrives(): the hits that want to hear of it
template <class Tile, class Sink>
class ShadowCaster {
public:
    ShadowCaster(Context& context, const Tile& tile, Sink& sink)
        : context_(context), scratch_(context.scratch.shade), tile_(tile), sink_(sink)
    {}

    /// Shadow rays to a light without extent. asking: the points that want to know; all: those that have asked for the
    /// light.
    void cast(const light::Light& light, HitMask asking, HitMask all)
    {
        if (light.projector) asking &= project(light, asking);
        const double least = context_.scene.tolerance.shadow;
        const HitMask near = light.shadowless ? asking
                                              : find_shadow_ends(least, scratch_.hits, tile_.hits, scratch_.lamp.light,
                                                                 scratch_.shadow.ends, tile_.count());
        sink_.light(asking & near);
        asking &= ~near;
        if (asking == 0) return;
        const bool opaque = light.from_one_point() && on_one_side(context_.traits.clear_slab, light);
        // From the light, where they form a beam.
        const bool from_light = light.from_one_point() && !context_.traits.has_open_surface &&
                                (opaque || !asks_own_rays(light, asking)) && !context_.scene.geometry.faithful &&
                                ((all & beyond(scratch_.lamp.light, kFarLight * least, tile_.count())) == 0 ||
                                 (Tile::kInAir && stands_among(light, kFarLight * least)));
        answer(light, shadow_rays(scratch_, asking, from_light ? &light.location : nullptr), opaque);
    }

    /// The same of an area light, for all points at once: what reaches them, in `seen`.
    void cast_area(const light::Light& light, HitMask asking, TileColors& seen)
    {
        std::array<const InteriorList*, csg::kTileRays> around;
        for_each_hit(asking, [&](std::size_t k) { around[k] = &tile_.interiors(k); });
        AreaLight area(context_, light, tile_.hits, around.data());
        area.shadows(asking, seen);
        if (!light.atmosphere || light.shadowless) return;
        for_each_hit(asking, [&](std::size_t k) {
            // The rest of the way as from the sample that was asked last, or all of it twice (spec 6, 2.8).
            const AreaLight::Rest rest = light.dimmed_twice ? AreaLight::Rest{scratch_.lamp.light.direction(k), 0.0,
                                                                              scratch_.lamp.light.distance[k]}
                                                            : area.rest(k);
            RayState ray;
            ray.ray = {scratch_.hits.point(k), rest.direction};
            ray.interiors = tile_.interiors(k);
            const glm::vec3 share = atmosphere_share(context_, ray, rest.from, rest.to, true);
            seen.set(k, seen[k] * share * (light.dimmed_twice ? share : glm::vec3(1)));
        });
    }

private:
    /// Whether everything bounded lies nearer to the light than `distance`. Rays to points of the air that are very far
    /// off then begin at the light: from such a point they would have so few digits that they miss boxes by a unit or
    /// so.
    bool stands_among(const light::Light& light, double distance) const
    {
        const csg::Bvh& bvh = context_.world.data().bvh;
        if (bvh.nodes.empty()) return true;
        const glm::dvec3 far =
            glm::max(glm::abs(bvh.bounds.lower - light.location), glm::abs(bvh.bounds.upper - light.location));
        return glm::length(far) < distance;
    }

    /// The light at one point and all others lie on one side of what a slab holds.
    bool on_one_side(const plan::Slab& slab, const light::Light& light) const
    {
        if (slab.axis == plan::Slab::kNoAxis) return false;
        const TileLanes& points = slab.axis == 0 ? scratch_.hits.x : slab.axis == 1 ? scratch_.hits.y : scratch_.hits.z;
        const double at = light.location[slab.axis];
        if (slab.upper < at) return least_of(points, at) > slab.upper;
        return slab.lower > at && most_of(points, at) < slab.lower;
    }

    /// Something that shadow rays have to meet from the point itself may be met (SceneTraits::own_rays).
    bool asks_own_rays(const light::Light& light, HitMask asking) const
    {
        const std::vector<csg::Aabb>& boxes = context_.traits.own_rays;
        if (boxes.empty() || on_one_side(context_.traits.own_rays_slab, light)) return false;
        const std::array<const TileLanes*, 3> lanes{&scratch_.hits.x, &scratch_.hits.y, &scratch_.hits.z};
        const glm::dvec3& from = light.location;
        const std::array<Interval, 3> at{span(*lanes[0], from.x, asking), span(*lanes[1], from.y, asking),
                                         span(*lanes[2], from.z, asking)};
        const glm::dvec3 low(at[0].low, at[1].low, at[2].low), high(at[0].high, at[1].high, at[2].high);
        return std::any_of(boxes.begin(), boxes.end(), [&](const csg::Aabb& box) {
            return glm::all(glm::lessThanEqual(box.lower, high)) && glm::all(glm::greaterThanEqual(box.upper, low));
        });
    }

    struct Interval {
        double low, high;
    };
    /// The least or the most of a coordinate of the light and all points of whole lanes.
    double least_of(const TileLanes& of, double light) const
    {
        using numbers::lanes::Double;
        return numbers::lanes::lowest(folded(of, light, [](Double a, Double b) { return xsimd::min(a, b); }));
    }
    double most_of(const TileLanes& of, double light) const
    {
        using numbers::lanes::Double;
        return -numbers::lanes::lowest(-folded(of, light, [](Double a, Double b) { return xsimd::max(a, b); }));
    }
    template <class Fold>
    numbers::lanes::Double folded(const TileLanes& of, double light, Fold&& fold) const
    {
        using numbers::lanes::Double;
        Double out(light);
        // In this order what is no number is not taken.
        const auto take = [&](int i) { out = fold(Double::load_aligned(of.data() + i), out); };
        if (tile_.count() == csg::kTileRays)  // a loop of known length, which takes half of the instructions
            for (int i = 0; i < csg::kTileRays; i += numbers::lanes::kDoubles) take(i);
        else
            for (int i = 0; i < tile_.count(); i += numbers::lanes::kDoubles) take(i);
        return out;
    }
    /// The least and the most of a coordinate of the light and the points that ask.
    Interval span(const TileLanes& of, double light, HitMask asking) const
    {
        using numbers::lanes::Double;
        Double least(light), most(light);
        for (int i = 0; i < tile_.count(); i += numbers::lanes::kDoubles) {
            const auto lanes = numbers::lanes::lanes_of(static_cast<std::uint32_t>(asking >> i));
            const Double at = Double::load_aligned(of.data() + i);
            least = xsimd::select(lanes, xsimd::min(least, at), least);
            most = xsimd::select(lanes, xsimd::max(most, at), most);
        }
        return {numbers::lanes::lowest(least), -numbers::lanes::lowest(-most)};
    }

    /// The points that see a light through its projector, where their shadow rays end then; the others are dark.
    HitMask project(const light::Light& light, HitMask asking)
    {
        if (asking == 0) return 0;
        HitMask seen = 0;
        csg::RayTile& rays = scratch_.shadow.rays;
        rays.count = 0;
        rays.common_origin = false;
        for_each_hit(asking, [&](std::size_t k) {
            const auto ray = static_cast<std::size_t>(rays.count++);
            scratch_.shadow.lane[ray] = static_cast<std::uint8_t>(k);
            rays.set(ray, {scratch_.hits.point(k), scratch_.lamp.light.direction(k)}, 0.0, 0.0);
        });
        projected_depths(*light.projector, rays, [&](std::size_t ray, double depth) {
            const std::size_t k = scratch_.shadow.lane[ray];
            if (depth < 0.0 || depth >= scratch_.lamp.light.distance[k]) return sink_.arrive(k, glm::vec3(0));
            scratch_.lamp.light.distance[k] = depth;
            seen |= HitMask{1} << k;
        });
        return seen;
    }

    /// What the shadow rays tell. `in_order`: ray i is point i's; `opaque`: they come near nothing that is not.
    void answer(const light::Light& light, bool in_order, bool opaque)
    {
        const RayTile& beam = scratch_.shadow.rays;
        csg::CrossingTile& met = scratch_.shadow.crossings;
        context_.scratch.counts.shadow += static_cast<std::uint64_t>(beam.count);
        if (context_.traits.filters && !opaque) {
            context_.world.shadow_crossings(beam, context_.scratch.geometry, met);
        } else {
            context_.world.shadow(beam, context_.scratch.geometry, met.ending.data());
            met.count.fill(0);
        }
        tell<&Recorder::shadow_rays>(scratch_, in_order);
        const auto hit_of = [&](std::size_t ray) { return in_order ? ray : scratch_.shadow.lane[ray]; };
        const HitMask rays = first_hits(beam.count), blocked = rays & equal(met.ending, Shadow::Blocked);
        const HitMask clear = light.atmosphere ? 0 : rays & equal(met.ending, Shadow::Clear);  // fog dims all of them
        HitMask reached = clear;
        if (!in_order) {
            reached = 0;
            for_each_hit(clear, [&](std::size_t ray) { reached |= HitMask{1} << hit_of(ray); });
        }
        sink_.light(reached);
        pass_filtered(rays & ~clear & ~blocked, light.atmosphere, hit_of);
        if (sink_.arrives() != 0)
            for_each_hit(blocked, [&](std::size_t ray) { sink_.arrive(hit_of(ray), glm::vec3(0)); });
    }

    /// Points whose light is filtered; `rays`: theirs.
    template <class HitOf>
    void pass_filtered(HitMask rays, bool in_air, const HitOf& hit_of)
    {
        if (rays == 0) return;
        filters_known_ = false;
        if (context_.traits.restarts()) restart(rays, hit_of);
        else if (context_.traits.filters_together) find_filters(rays, hit_of);
        const plan::CompiledScene& scene = context_.scene;
        const bool media = context_.traits.media || (in_air && scene.atmosphere.extinguishes);
        MediaShadows* later = media ? &context_.scratch.shadow_media().shadows : nullptr;
        const auto tell = [&](std::size_t k, const glm::vec3& color) {
            sink_.light(k, color);
            sink_.arrive(k, color);
        };
        HitMask waiting = 0;  // media have to be sampled on the way
        std::size_t stretches = 0;
        TileColors colors;
        for_each_hit(rays, [&](std::size_t ray) {
            const std::size_t k = hit_of(ray);
            const glm::vec3 color = filtered(ray, k, {in_air, later, k});
            const bool waits = later != nullptr && !later->empty() && later->size() != stretches;
            if (!waits) return tell(k, color);
            stretches = later->size();
            waiting |= HitMask{1} << k;
            colors.set(k, color);
        });
        if (waiting == 0) return;
        later->run(scene, [&](std::size_t k, const glm::vec3& share) { colors.set(k, colors[k] * share); });
        for_each_hit(waiting, [&](std::size_t k) { tell(k, colors[k]); });
    }

    /// What surfaces with patterns or caustics leave of light. Crossings of rays from the light are turned round.
    template <class HitOf>
    [[gnu::noinline]] void find_filters(HitMask rays, const HitOf& hit_of)
    {
        filters_known_ = true;
        SurfaceFilters filters(context_);
        csg::CrossingTile& met = scratch_.shadow.crossings;
        for_each_hit(rays & ~equal(met.ending, Shadow::Clear), [&](std::size_t ray) {
            if (met.count[ray] == csg::CrossingTile::kTooMany) return;
            const std::size_t k = hit_of(ray);
            if (scratch_.shadow.rays.common_origin)
                turn_round(met.hits[ray].data(), met.count[ray], scratch_.lamp.light.distance[k]);
            filters.add(ray, {scratch_.hits.point(k), scratch_.lamp.light.direction(k)}, met.hits[ray].data(),
                        met.count[ray]);
        });
        filters.run();
    }

    /// The crossings of rays that begin anew behind each of them.
    template <class HitOf>
    [[gnu::noinline]] void restart(HitMask rays, const HitOf& hit_of)
    {
        RestartedRays restarted(context_);
        const csg::CrossingTile& met = scratch_.shadow.crossings;
        for_each_hit(rays & ~equal(met.ending, Shadow::Clear), [&](std::size_t ray) {
            const std::size_t k = hit_of(ray);
            const double tolerance = scratch_.shadow.ends.from[k], end = scratch_.lamp.light.distance[k] - tolerance;
            if (end <= tolerance) return;
            const bool too_many = met.count[ray] == csg::CrossingTile::kTooMany;
            restarted.add(k, {scratch_.hits.point(k), scratch_.lamp.light.direction(k)}, tolerance, end,
                          too_many ? nullptr : met.hits[ray].data());
        });
        restarted.run();
    }

    static HitMask equal(const std::array<Shadow, csg::kTileRays>& endings, Shadow to)
    {
        return numbers::lanes::equal(reinterpret_cast<const std::uint8_t*>(endings.data()),
                                     static_cast<std::uint8_t>(to));
    }

    /// The light at hand past what a shadow ray crosses.
    glm::vec3 filtered(std::size_t ray, std::size_t k, const ShadowAir& air)
    {
        const light::Illumination lit{scratch_.lamp.light.direction(k), scratch_.lamp.light.distance[k],
                                      scratch_.lamp.colors[k]};
        const bool clear = scratch_.shadow.crossings.ending[ray] == Shadow::Clear;
        const std::uint8_t count = clear ? 0 : scratch_.shadow.crossings.count[ray];
        const bool too_many = count == csg::CrossingTile::kTooMany;
        const PhotonShadow& caught = scratch_.lamp.photons;
        if (too_many || (context_.traits.restarts() && !clear)) {
            const glm::vec3 passed = filtered_light(
                context_, scratch_.hits.point(k), scratch_.shadow.ends.from[k], tile_.interiors(k), lit, lit.color, air,
                nullptr, context_.traits.restarts() ? &scratch_.restarted().rays[k] : nullptr);
            const auto& crossings = context_.scratch.crossings;
            return caught.stops(k, crossings.data(), crossings.size()) ? glm::vec3(0) : passed;
        }
        if (caught.stops(k, scratch_.shadow.crossings.hits[ray].data(), count)) return glm::vec3(0);
        return shadow_transmittance(context_, scratch_.hits.point(k), scratch_.shadow.ends.from[k], tile_.interiors(k),
                                    lit, scratch_.shadow.rays.common_origin && !filters_known_,
                                    scratch_.shadow.crossings.hits[ray].data(), count, air,
                                    filters_known_ ? scratch_.filters().filters[ray].data() : nullptr);
    }

    Context& context_;
    ShadeScratch& scratch_;
    const Tile& tile_;
    Sink& sink_;
    bool filters_known_ = false;  ///< FilterScratch::filters are those of the light at hand
};

}  // namespace trace
