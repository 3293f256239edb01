#pragma once

#include "render/kernel/gather/indirect_light.h"
#include "render/kernel/light/tile_attenuation.h"
#include "render/kernel/light/direct_batch.h"
#include "render/kernel/light/node_lanes.h"
#include "render/kernel/context/segment_tile.h"
#include "render/kernel/light/shade_light.h"
#include "render/kernel/light/shadow_caster.h"
#include "render/kernel/record/recorder.h"
#include "render/kernel/tile/nearly_zero.h"
#include "render/plan/shines_on.h"
#include "render/kernel/context/photon_shadow.h"

/// The lights over a tile's rows.
namespace trace {

class LightStage {
public:
    LightStage(Context& context, const SegmentTile& tile, DirectBatch& batch)
        : context_(context), scratch_(context.scratch.shade), tile_(tile), batch_(batch),
          shadows_(context.scene.settings.quality.shadows)
    {}

    void run()
    {
        if (context_.filling != nullptr && context_.bounce == 0) return;  // nobody looks at what the camera sees
        const auto& lights = context_.lights.lights;
        if (batch_.scalar() != 0) scratch_.rows.samples.resize(lights.size() * kTileRays);
        scratch_.lamp.photons.scene = nullptr;
        if (context_.indirect != nullptr) find_photon_shadow();
        for (std::size_t i = 0; i < lights.size() && batch_.lit() != 0; ++i) {
            asks_ = batch_.lit();
            if (context_.traits.grouped) asks_ &= shone_on(lights[i]);
            which_ = i;
            if (asks_ == 0) continue;
            scratch_.lamp.photons.of_light(i);
            add(lights[i]);
            tell<&Recorder::lamp>(scratch_, batch_.depths(), i, asks_);
        }
        if (batch_.scalar() != 0) add_scalar();
    }

private:
    /// The light is added to the hits of asks_.
    void add(const light::Light& light)
    {
        const HitMask colored = steady(light) ? illuminate_from_point(light) : illuminate_each(light);
        for_each_hit(asks_ & batch_.scalar(), [&](std::size_t k) {
            LightSample& to = sample(k);
            to.lit.direction = scratch_.lamp.light.direction(k);
            to.lit.distance = scratch_.lamp.light.distance[k];
            to.lit.color = scratch_.lamp.colors[k];
            to.arriving = light.area_illumination ? light.color : scratch_.lamp.colors[k];
        });
        const bool shadows = shadows_ && (!light.shadowless || light.projector);
        if (light.area && (shadows || light.area_illumination)) {
            const HitMask asking = light.area_illumination ? asks_ : asks_ & colored & facing();
            if (asking != 0) add_area(light, asking, shadows);
            return;
        }
        const HitMask asking = asks_ & colored & facing();
        if (shadows) caster().cast(light, asking, asks_);
        else batch_.light(asking);
        batch_.add(light, tile_.rays);
    }

    /// An area light, whose shadows are found for all hits at once.
    void add_area(const light::Light& light, HitMask asking, bool shadows)
    {
        TileColors& seen = scratch_.lamp.shadowed;
        if (shadows) {
            caster().cast_area(light, asking, seen);
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
        NodeLanes lanes(light, reached, scratch_, tile_.count());
        batch_.begin_group();
        for (int j = 0; j < light.size2; ++j)
            for (int i = 0; i < light.size1; ++i) {
                lanes.ask(i, j, seen);
                for_each_hit(reached, [&](std::size_t k) { batch_.begin_light(k, scratch_.lamp.reaching[k]); });
                batch_.light(reached & facing());
                batch_.add(light, tile_.rays);
            }
        batch_.end_group();
    }

    /// Rows that lanes don't know, when all lights have been asked.
    void add_scalar()
    {
        Hit met;
        const auto place = [&](std::size_t k) {
            met = tile_.hits.at(static_cast<int>(k));
            return tile_.place(k, tile_.state(k), met);
        };
        batch_.add_scalar(place,
                          [&](std::size_t k) { return &scratch_.rows.samples[k * context_.lights.lights.size()]; });
    }

    /// Where shadow rays tell what arrives.
    struct Sink {
        LightStage& stage;
        void light(HitMask hits) { stage.batch_.light(hits); }
        void light(std::size_t k, const glm::vec3& color) { stage.batch_.light(k, color); }
        void arrive(std::size_t k, const glm::vec3& color) { stage.arrive(k, color); }
        HitMask arrives() const { return stage.batch_.scalar(); }
    };
    ShadowCaster<SegmentTile, Sink> caster() { return {context_, tile_, sink_}; }

    LightSample& sample(std::size_t k) { return scratch_.rows.samples[k * context_.lights.lights.size() + which_]; }
    /// What a shadow leaves of the light at hand, for rows that are looked up by themselves.
    void arrive(std::size_t k, const glm::vec3& color)
    {
        if (has(batch_.scalar(), k)) sample(k).arriving = color;
    }

    /// Hits whose shadow rays end at targets.
    [[gnu::noinline]] void find_photon_shadow()
    {
        if (context_.indirect->photons.empty()) return;
        const plan::CompiledScene& scene = context_.scene;
        scratch_.lamp.photons.scene = &scene;
        scratch_.lamp.photons.lit = 0;
        for_each_hit(batch_.lit(), [&](std::size_t k) {
            if (collects(scene, tile_.hits.surface[k])) scratch_.lamp.photons.lit |= HitMask{1} << k;
        });
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
        toward_lamp(light, scratch_.hits, tile_.count(), scratch_.lamp.light);
        std::fill_n(scratch_.lamp.colors.begin(), tile_.count(), light.color);
        batch_.begin_light(light.color);
        return light.color == glm::vec3(0) ? 0 : ~HitMask{0};
    }

    /// The same of any light.
    HitMask illuminate_each(const light::Light& light)
    {
        HitMask colored = 0;
        const auto lit = [&](std::size_t k, const glm::vec3& color) {
            scratch_.lamp.colors[k] = color;
            batch_.begin_light(k, color);
            colored |= HitMask{color != glm::vec3(0) ? 1u : 0u} << k;
        };
        toward_lamp(light, scratch_.hits, tile_.count(), scratch_.lamp.light);
        alignas(64) TileLanes share;
        attenuate(light, asks_, scratch_.hits, scratch_.lamp.light, share);
        for_each_hit(asks_, [&](std::size_t k) { lit(k, light.color * static_cast<float>(share[k])); });
        return colored;
    }

    /// Hits of which some row faces the light at hand.
    HitMask facing() const
    {
        using numbers::lanes::Double;
        HitMask away = 0;
        for (int i = 0; i < tile_.count(); i += numbers::lanes::kDoubles) {
            const auto get = [i](const TileLanes& lanes) { return Double::load_aligned(lanes.data() + i); };
            const Double cosine = get(scratch_.hits.nx) * get(scratch_.lamp.light.x) +
                                  get(scratch_.hits.ny) * get(scratch_.lamp.light.y) +
                                  get(scratch_.hits.nz) * get(scratch_.lamp.light.z);
            away |= HitMask{numbers::lanes::mask(cosine < Double(kNearlyZero))} << i;
        }
        HitMask toward = ~away;
        for_each_hit(batch_.all_bent(), [&](std::size_t k) {
            const HitMask bit = HitMask{1} << k;
            toward = batch_.faces(k, scratch_.lamp.light.direction(k)) ? toward | bit : toward & ~bit;
        });
        return toward | batch_.two_sided();
    }

    Context& context_;
    ShadeScratch& scratch_;
    const SegmentTile& tile_;
    DirectBatch& batch_;
    bool shadows_;
    std::size_t which_ = 0;  ///< the light at hand
    HitMask asks_ = 0;       ///< hits that it changes
    Sink sink_{*this};
};

}  // namespace trace
