#pragma once

#include "numbers/lane_equal.h"
#include "csg/items/depth_range.h"
#include "render/kernel/context/context.h"
#include "render/kernel/tile/hit_mask.h"

namespace trace {

/// A tile of segments that have been traced, with all that they inherit; then their hits as points and normals.
class SegmentTile {
public:
    static constexpr bool kInAir = false;  ///< for ShadowCaster

    /// queued: what the rays inherit; null for camera rays, which share `camera` but for its interiors where there are
    /// `starts`.
    SegmentTile(Context& context, const RayTile& traced, const HitTile& met, const RayState& camera,
                const InteriorList* starts, const QueuedRay* queued)
        : rays(traced), hits(met), context_(context), scratch_(context.scratch.shade), camera_(camera), starts_(starts),
          queued_(queued), own_(camera)
    {
        const HitMask all = first_hits(rays.count);
        found_ = all & ~numbers::lanes::equal(hits.surface, csg::kNoSurface);
        count_far();
        find_places();
    }

    const RayTile& rays;
    const HitTile& hits;

    int count() const { return rays.count; }
    /// Rays that met something; those whose raw normal faces along the ray; those without details of their own.
    HitMask found() const { return found_; }
    HitMask from_inside() const { return from_inside_; }
    HitMask batched() const { return batched_; }

    int level(std::size_t k) const { return queued_ == nullptr ? camera_.level + 1 : queued_[k].level; }
    /// Whether the segments are secondary rays, from hits of other tiles; else they are camera rays.
    bool is_queued() const { return queued_ != nullptr; }
    /// Whether all segments inherit the same state.
    bool alike() const { return queued_ == nullptr && starts_ == nullptr; }
    ColorSlot slot(std::size_t k) const { return queued_ == nullptr ? static_cast<ColorSlot>(k) : queued_[k].slot; }
    const InteriorList& interiors(std::size_t k) const
    {
        return queued_ != nullptr ? queued_[k].state.interiors : starts_ != nullptr ? starts_[k] : camera_.interiors;
    }
    /// Whether no segment is inside of anything that has an interior.
    bool all_outside() const
    {
        return none([](const InteriorList& list) { return list.size(); });
    }
    /// Whether, besides, none has a clouded list (InteriorList::cloud): fog shows along all of them.
    bool all_open() const
    {
        return none([](const InteriorList& list) { return list.closed(); });
    }
    csg::Ray ray(std::size_t k) const
    {
        return queued_ != nullptr ? queued_[k].state.ray : rays.ray(static_cast<int>(k));
    }
    /// What segment k inherits, but for what has a function of its own: of a camera ray root, ray and interiors.
    const RayState& inherited(std::size_t k) const { return queued_ != nullptr ? queued_[k].state : camera_; }
    std::uint8_t root(std::size_t k) const
    {
        return queued_ != nullptr ? queued_[k].state.root : static_cast<std::uint8_t>(k);
    }
    plan::RayKind kind(std::size_t k) const { return queued_ != nullptr ? queued_[k].state.kind : camera_.kind; }
    /// The ray with all that it inherits; valid until the next call.
    [[gnu::always_inline]] const RayState& state(std::size_t k) const
    {
        if (queued_ != nullptr) return queued_[k].state;
        own_.ray = rays.ray(static_cast<int>(k));
        own_.root = static_cast<std::uint8_t>(k);
        if (starts_ != nullptr) own_.interiors = starts_[k];
        return own_;
    }

    HitPlace place(std::size_t k, const RayState& state, const Hit& hit) const
    {
        return {state,
                hit,
                context_.scene.surfaces[hit.surface],
                scratch_.hits.point(k),
                scratch_.hits.normal(k),
                level(k),
                has(from_inside_, k)};
    }

    HitContext context(std::size_t k, const RayState& state, const Hit& hit) const
    {
        return {state,
                hit,
                context_.scene.surfaces[hit.surface],
                scratch_.hits.point(k),
                scratch_.hits.normal(k),
                level(k),
                has(from_inside_, k),
                k};
    }

    /// What World::details says of hit k.
    const HitDetails& details(std::size_t k) const
    {
        HitDetails& at = scratch_.details[k];
        if (has(batched_, k)) {
            const glm::dvec3 n = scratch_.hits.normal(k);
            at = {scratch_.hits.point(k), has(from_inside_, k) ? -n : n};
        }
        return at;
    }

    /// The texture that the hit shows, or plan::kNone.
    std::uint32_t texture(std::size_t k) const
    {
        return context_.scene.surfaces[hits.surface[k]].texture_of(has(from_inside_, k));
    }

private:
    static constexpr std::size_t kFewSurfaces = 4;  // looked for in lanes

    /// Whether `ask` is 0 for every list of interiors: found without a branch for each.
    template <class Ask>
    bool none(const Ask& ask) const
    {
        const auto many = static_cast<std::size_t>(rays.count);
        decltype(ask(camera_.interiors)) any = 0;
        if (queued_ != nullptr)
            for (std::size_t k = 0; k < many; ++k) any |= ask(queued_[k].state.interiors);
        else if (starts_ != nullptr)
            for (std::size_t k = 0; k < many; ++k) any |= ask(starts_[k]);
        else any = ask(camera_.interiors);
        return any == 0;
    }

    /// Points and normals that face the viewer.
    void find_places()
    {
        TileHits& places = scratch_.hits;
        batched_ = found_;
        const auto& single = context_.traits.not_batched;
        if (single.size() <= kFewSurfaces)
            for (const csg::SurfaceId surface : single) batched_ &= ~numbers::lanes::equal(hits.surface, surface);
        else
            for_each_hit(found_, [&](std::size_t k) {
                if (!context_.traits.surfaces[hits.surface[k]].batched) batched_ &= ~(HitMask{1} << k);
            });
        context_.world.shading_points(rays, hits, batched_, places);
        for_each_hit(found_ & ~batched_, [&](std::size_t k) {
            // Built in place: copying what was just written in smaller pieces would stall on store forwarding.
            const auto i = static_cast<int>(k);
            const HitDetails& at = *new (&scratch_.details[k])
                                       HitDetails(hit_details(context_, rays.ray(i), hits.at(i)));
            places.set(k, at.point, at.normal);
        });
        const HitMask lanes = first_hits((rays.count + csg::kTileSide - 1) / csg::kTileSide * csg::kTileSide);
        for_each_hit(lanes & ~found_, [&](std::size_t k) { places.set(k, glm::dvec3(0), glm::dvec3(0)); });
        from_inside_ = found_ & turn_to_viewer(rays, places);
    }

    /// Counts hits beyond the distance at which POV-Ray finds any, so that the user can be told.
    void count_far()
    {
        using numbers::lanes::Double;
        HitMask far = 0;
        for (int i = 0; i < rays.count; i += numbers::lanes::kDoubles)
            far |=
                HitMask{numbers::lanes::mask(Double::load_aligned(hits.t.data() + i) > Double(csg::DepthRange::kFar))}
                << i;
        far &= found_;
        for_each_hit(far, [&](std::size_t k) {
            context_.scratch.counts.far += context_.world.too_far(hits.at(static_cast<int>(k))) ? 1 : 0;
        });
    }

    Context& context_;
    ShadeScratch& scratch_;
    const RayState& camera_;
    const InteriorList* starts_;
    const QueuedRay* queued_;
    mutable RayState own_;  ///< of the camera ray asked for last
    HitMask found_ = 0, batched_ = 0, from_inside_ = 0;
};

}  // namespace trace
