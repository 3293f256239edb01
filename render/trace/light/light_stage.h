#pragma once

#include "render/trace/light/area_light.h"
#include "render/trace/light/direct_batch.h"
#include "render/trace/queue/segment_tile.h"
#include "render/trace/light/shade_light.h"
#include "render/trace/light/shadow_rays.h"

#include <algorithm>

/// The lights over a tile's rows. Compiled once per instruction set.
namespace trace {

/// Beyond so many tolerances, 1e5 as a rule, a shadow ray starts at the hit: from a far light, t would lose digits
/// against one.
inline constexpr double kFarLight = 1e8;

/// Lit from one point with one colour everywhere: its directions are found in vector lanes.
inline bool steady(const light::Light& light)
{
    return light.kind == light::Light::Kind::Point && !light.parallel && !light.area && !(light.fade_power > 0.0);
}

class LightStage {
public:
    LightStage(Context& context, const SegmentTile& tile, DirectBatch& batch)
        : context_(context), scratch_(context.scratch.shade), tile_(tile), batch_(batch),
          shadows_(context.scene.settings.quality >= 4)
    {}

    void run()
    {
        const auto& lights = context_.scene.lights.lights;
        if (batch_.scalar() != 0) scratch_.samples.resize(lights.size() * kTileRays);
        for (std::size_t i = 0; i < lights.size() && batch_.lit() != 0; ++i) {
            asks_ = batch_.lit();
            if (scratch_.traits.grouped) asks_ &= shone_on(lights[i]);
            which_ = i;
            if (asks_ != 0) add(lights[i]);
        }
        if (batch_.scalar() != 0) add_scalar();
    }

private:
    /// The light is added to the hits of asks_.
    void add(const light::Light& light)
    {
        const HitMask colored = steady(light) ? illuminate_from_point(light) : illuminate_each(light);
        for_each_hit(asks_ & batch_.scalar(), [&](std::size_t k) {
            const light::Illumination lit{scratch_.light.direction(k), scratch_.light.distance[k],
                                          scratch_.lit_colors[k]};
            sample(k) = {lit, light.area_illumination ? light.color : lit.color};
        });
        const bool shadows = shadows_ && (!light.shadowless || light.projector);
        if (light.area && (shadows || light.area_illumination)) {
            const HitMask asking = light.area_illumination ? asks_ : asks_ & colored & facing();
            if (asking != 0) add_area(light, asking, shadows);
            return;
        }
        const HitMask asking = asks_ & colored & facing();
        if (shadows) cast_shadows(light, asking);
        else batch_.light(asking);
        batch_.add(light, tile_.rays);
    }

    /// Shadow rays to a light without extent.
    void cast_shadows(const light::Light& light, HitMask asking)
    {
        if (light.projector) asking &= project(light, asking);
        const double least = context_.scene.tolerance.shadow;
        const HitMask near = light.shadowless ? asking
                                              : find_shadow_ends(least, scratch_.hits, tile_.hits, scratch_.light,
                                                                 scratch_.shadow_ends, tile_.count());
        batch_.light(asking & near);
        asking &= ~near;
        if (asking == 0) return;
        // From the light, where they form a beam.
        const bool from_light = light.from_one_point() && !scratch_.traits.has_open_surface &&
                                !asks_own_rays(light, asking) && !context_.scene.geometry.faithful &&
                                (asks_ & beyond(scratch_.light, kFarLight * least, tile_.count())) == 0;
        answer(light, shadow_rays(scratch_, asking, from_light ? &light.location : nullptr));
    }

    /// Something that shadow rays have to meet from the point itself may be met (SceneTraits::own_rays).
    bool asks_own_rays(const light::Light& light, HitMask asking) const
    {
        if (scratch_.traits.own_rays.empty()) return false;
        glm::dvec3 low = light.location, high = light.location;
        for_each_hit(asking, [&](std::size_t k) {
            low = glm::min(low, scratch_.hits.point(k));
            high = glm::max(high, scratch_.hits.point(k));
        });
        return std::any_of(scratch_.traits.own_rays.begin(), scratch_.traits.own_rays.end(), [&](const csg::Aabb& box) {
            return glm::all(glm::lessThanEqual(box.lower, high)) && glm::all(glm::greaterThanEqual(box.upper, low));
        });
    }

    /// The hits that see a light through its projector, where their shadow rays end then; the others are dark.
    HitMask project(const light::Light& light, HitMask asking)
    {
        HitMask seen = 0;
        for_each_hit(asking, [&](std::size_t k) {
            const double depth = light.projector->depth({scratch_.hits.point(k), scratch_.light.direction(k)});
            if (depth < 0.0 || depth >= scratch_.light.distance[k]) return arrive(k, glm::vec3(0));
            scratch_.light.distance[k] = depth;
            seen |= HitMask{1} << k;
        });
        return seen;
    }

    /// An area light, whose shadows are found for all hits at once.
    void add_area(const light::Light& light, HitMask asking, bool shadows)
    {
        TileColors& seen = scratch_.area_colors;
        if (shadows) {
            std::array<const InteriorList*, csg::kTileRays> around;
            for_each_hit(asking, [&](std::size_t k) { around[k] = &tile_.interiors(k); });
            AreaLight(context_, light, tile_.hits, around.data()).shadows(asking, seen);
            if (light.atmosphere && !light.shadowless)  // as if all of it came from the centre
                for_each_hit(asking, [&](std::size_t k) {
                    if (!tile_.interiors(k).all_hollow(context_.scene.interiors)) return;
                    seen.set(k, seen[k] * fog_share(context_, {scratch_.hits.point(k), scratch_.light.direction(k)},
                                                    scratch_.light.distance[k]));
                });
        } else {
            for_each_hit(asking, [&](std::size_t k) { seen.set(k, light.color); });
        }
        for_each_hit(asking & batch_.scalar(), [&](std::size_t k) { arrive(k, seen[k]); });
        if (light.area_illumination) return add_nodes(light, asking, seen);
        for_each_hit(asking, [&](std::size_t k) { batch_.light(k, seen[k]); });
        batch_.add(light, tile_.rays);
    }

    /// area_illumination: every node is a light of its own under one common shadow (spec 3, 12.7).
    void add_nodes(const light::Light& light, HitMask asking, const TileColors& seen)
    {
        HitMask reached = 0;
        for_each_hit(asking, [&](std::size_t k) { reached |= dark(seen[k]) ? 0 : HitMask{1} << k; });
        if (reached == 0) return;
        batch_.begin_group();
        for (int j = 0; j < light.size2; ++j)
            for (int i = 0; i < light.size1; ++i) {
                for_each_hit(reached, [&](std::size_t k) {
                    const glm::dvec3 point = scratch_.hits.point(k);
                    const light::Illumination lit =
                        light::illuminate(light, point, light::node_offset(light, point, i, j));
                    scratch_.light.x[k] = lit.direction.x;
                    scratch_.light.y[k] = lit.direction.y;
                    scratch_.light.z[k] = lit.direction.z;
                    batch_.begin_light(k, node_color(light, lit, seen[k]));
                });
                batch_.light(reached & facing());
                batch_.add(light, tile_.rays);
            }
        batch_.end_group();
    }

    /// Rows that lanes don't know, when all lights have been asked.
    void add_scalar()
    {
        RayState own;
        Hit met;
        const auto place = [&](std::size_t k) {
            met = tile_.hits.at(static_cast<int>(k));
            return tile_.place(k, tile_.state(k, own), met);
        };
        batch_.add_scalar(place,
                          [&](std::size_t k) { return &scratch_.samples[k * context_.scene.lights.lights.size()]; });
    }

    LightSample& sample(std::size_t k) { return scratch_.samples[k * context_.scene.lights.lights.size() + which_]; }
    /// What a shadow leaves of the light at hand, for rows that are looked up by themselves.
    void arrive(std::size_t k, const glm::vec3& color)
    {
        if (has(batch_.scalar(), k)) sample(k).arriving = color;
    }

    /// Hits that the light's group lets it shine on.
    HitMask shone_on(const light::Light& light) const
    {
        HitMask on = 0;
        for_each_hit(asks_, [&](std::size_t k) {
            if (shines_on(light, context_.scene.surfaces[tile_.hits.surface[k]])) on |= HitMask{1} << k;
        });
        return on;
    }

    /// Directions, distances and colours of a light at one point; the hits where it has a colour.
    HitMask illuminate_from_point(const light::Light& light)
    {
        toward_point(light, scratch_.hits, tile_.count(), scratch_.light);
        scratch_.lit_colors.fill(light.color);
        batch_.begin_light(light.color);
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
            batch_.begin_light(k, lit.color);
            if (lit.color != glm::vec3(0)) colored |= HitMask{1} << k;
        });
        return colored;
    }

    /// Hits of which some row faces the light at hand.
    HitMask facing() const
    {
        using csg::lanes::Double;
        HitMask away = 0;
        for (int i = 0; i < tile_.count(); i += csg::lanes::kDoubles) {
            const auto get = [i](const TileLanes& lanes) { return Double::load_aligned(lanes.data() + i); };
            const Double cosine = get(scratch_.hits.nx) * get(scratch_.light.x) +
                                  get(scratch_.hits.ny) * get(scratch_.light.y) +
                                  get(scratch_.hits.nz) * get(scratch_.light.z);
            away |= HitMask{csg::lanes::mask(cosine < Double(kNearlyZero))} << i;
        }
        HitMask toward = ~away;
        for_each_hit(batch_.all_bent(), [&](std::size_t k) {
            const HitMask bit = HitMask{1} << k;
            toward = batch_.faces(k, scratch_.light.direction(k)) ? toward | bit : toward & ~bit;
        });
        return toward | batch_.two_sided();
    }

    /// What the shadow rays tell. `in_order`: ray i is hit i's.
    void answer(const light::Light& light, bool in_order)
    {
        const RayTile& beam = scratch_.rays;
        csg::CrossingTile& met = scratch_.crossings;
        context_.scratch.counts.shadow += static_cast<std::uint64_t>(beam.count);
        if (scratch_.traits.filters) context_.world.shadow_crossings(beam, context_.scratch.geometry, met);
        else context_.world.shadow(beam, context_.scratch.geometry, met.ending.data());
        const auto hit_of = [&](std::size_t ray) { return in_order ? ray : scratch_.lane[ray]; };
        const HitMask rays = first_hits(beam.count), blocked = rays & equal(met.ending, Shadow::Blocked);
        const HitMask clear = light.atmosphere ? 0 : rays & equal(met.ending, Shadow::Clear);  // fog dims all of them
        HitMask reached = clear;
        if (!in_order) {
            reached = 0;
            for_each_hit(clear, [&](std::size_t ray) { reached |= HitMask{1} << hit_of(ray); });
        }
        batch_.light(reached);
        for_each_hit(rays & ~clear & ~blocked, [&](std::size_t ray) {
            const std::size_t k = hit_of(ray);
            const glm::vec3 color = filtered(ray, k, light.atmosphere);
            batch_.light(k, color);
            arrive(k, color);
        });
        if (batch_.scalar() != 0) for_each_hit(blocked, [&](std::size_t ray) { arrive(hit_of(ray), glm::vec3(0)); });
    }

    static HitMask equal(const std::array<Shadow, csg::kTileRays>& endings, Shadow to)
    {
        return csg::lanes::equal(reinterpret_cast<const std::uint8_t*>(endings.data()), static_cast<std::uint8_t>(to));
    }

    /// The light at hand past what a shadow ray crosses, and fog if it dims light.
    glm::vec3 filtered(std::size_t ray, std::size_t k, bool in_fog)
    {
        const light::Illumination lit{scratch_.light.direction(k), scratch_.light.distance[k], scratch_.lit_colors[k]};
        const bool clear = scratch_.crossings.ending[ray] == Shadow::Clear;
        const std::uint8_t count = clear ? 0 : scratch_.crossings.count[ray];
        const bool too_many = count == csg::CrossingTile::kTooMany;
        if (too_many || (scratch_.traits.restarts() && !clear))
            return filtered_light(context_, scratch_.hits.point(k), scratch_.shadow_ends.from[k], tile_.interiors(k),
                                  lit, lit.color, in_fog, too_many ? nullptr : scratch_.crossings.hits[ray].data());
        return shadow_transmittance(context_, scratch_.hits.point(k), scratch_.shadow_ends.from[k], tile_.interiors(k),
                                    lit, scratch_.rays.common_origin, scratch_.crossings.hits[ray].data(), count,
                                    in_fog);
    }

    Context& context_;
    ShadeScratch& scratch_;
    const SegmentTile& tile_;
    DirectBatch& batch_;
    bool shadows_;
    std::size_t which_ = 0;  ///< the light at hand
    HitMask asks_ = 0;       ///< hits that it changes
};

}  // namespace trace
