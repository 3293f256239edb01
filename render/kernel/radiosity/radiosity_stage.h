#pragma once

#include "render/kernel/light/direct_batch.h"
#include "render/kernel/context/segment_tile.h"
#include "render/kernel/interior/interface.h"
#include "render/kernel/radiosity/ambient.h"

/// Light that surfaces hand on to each other, over a tile's rows (spec 6, 4.2).
namespace trace {

class RadiosityStage {
public:
    RadiosityStage(Context& context, const SegmentTile& tile, DirectBatch& batch)
        : context_(context), scratch_(context.scratch.shade), tile_(tile), batch_(batch)
    {}

    void run()
    {
        if (batch_.lit() == 0) return;
        light_side(batch_.lit(), &texture::Finish::gathered, 1.0);
        if (batch_.two_sided() != 0)
            light_side(batch_.lit() & batch_.two_sided(), &texture::Finish::gathered_back, -1.0);
    }

private:
    /// Of surfaces seen from one side, what arrives at it or, with `facing` -1, behind it.
    void light_side(HitMask hits, float texture::Finish::*diffuse, double facing)
    {
        radiosity::GatherScratch& gather = context_.scratch.gather();
        std::size_t count = 0;
        HitMask asking = 0;
        for_each_hit(hits, [&](std::size_t k) {
            for (std::size_t depth = 0; depth < batch_.depths(); ++depth) {
                const RowPage& at = scratch_.rows.pages[depth];
                if (!has(at.holds, k) || at.finish[k]->*diffuse == 0.0f) continue;
                const glm::vec3 share = at.filter[k] * at.pigment[k] * at.alpha[k] * (at.finish[k]->*diffuse);
                const auto amount = static_cast<double>(scene::grey(share));
                if (!(amount > context_.adc_bailout)) continue;
                ask(gather.requests[count], k, depth, amount, facing);
                lane_request_[k] = static_cast<std::uint8_t>(count++);
                asking |= HitMask{1} << k;
                break;
            }
        });
        if (count == 0) return;
        radiosity::find_ambient(context_, count);
        for_each_hit(asking, [&](std::size_t k) {
            const glm::vec3 ambient = gather.ambient[lane_request_[k]];
            for (std::size_t depth = 0; depth < batch_.depths(); ++depth) {
                RowPage& at = scratch_.rows.pages[depth];
                if (!has(at.holds, k)) continue;
                const float share = at.alpha[k] * (at.finish[k]->*diffuse) * seen_share(k, depth);
                at.gained.set(k, at.gained[k] + at.pigment[k] * ambient * share);
            }
        });
    }

    /// What is left of it on the way to the viewer (spec 7b, 1).
    float seen_share(std::size_t k, std::size_t depth) const
    {
        const texture::Finish& finish = *scratch_.rows.pages[depth].finish[k];
        if (finish.own_fresnel == 0.0f) return 1.0f;
        const double eta = fresnel_index(context_.scene.interiors, tile_.interiors(k),
                                         context_.scene.surfaces[tile_.hits.surface[k]].interior);
        return static_cast<float>(
            texture::seen_share(finish, tile_.state(k).ray.direction, batch_.normal(depth, k), eta));
    }

    void ask(radiosity::Request& to, std::size_t k, std::size_t depth, double amount, double facing) const
    {
        const RayState& state = tile_.state(k);
        to.point = scratch_.hits.point(k);
        to.normal = facing * scratch_.hits.normal(k);
        to.bent = facing * batch_.normal(depth, k);
        to.weight = static_cast<double>(state.weight) * amount;
        to.start = context_.scene.tolerance.hit_from(to.point, tile_.hits.t[k]);
        to.lane = static_cast<std::uint8_t>(k);
        to.root = state.root;
    }

    Context& context_;
    ShadeScratch& scratch_;
    const SegmentTile& tile_;
    DirectBatch& batch_;
    std::array<std::uint8_t, csg::kTileRays> lane_request_;
};

}  // namespace trace
