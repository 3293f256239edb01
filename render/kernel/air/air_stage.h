#pragma once

#include "render/kernel/air/rainbow.h"
#include "render/kernel/extinction/even_fog.h"
#include "render/kernel/extinction/uneven_fog.h"
#include "render/kernel/media/media_stage.h"
#include "render/kernel/context/segment_tile.h"
#include "render/kernel/record/recorder.h"

#include <algorithm>

/// What lies between the rays of a tile and what they have met: the one place where a stretch of air is crossed.
namespace trace {

/// Whether a scene has anything that AirStage looks for.
inline bool has_air(const Context& context)
{
    const plan::CompiledScene& scene = context.scene;
    if (!scene.settings.quality.effects || (scene.fogs.empty() && scene.rainbows.empty() && scene.media.media.empty()))
        return false;
    return context.bounce == 0 ? context.filling == nullptr : scene.radiosity->settings.media;
}

class AirStage {
    /// Over this part of its distance fog takes less than single precision tells.
    static constexpr double kUnseen = 0x1p-26;

public:
    AirStage(Context& context, const SegmentTile& tile) : context_(context), tile_(tile) {}

    /// Fills ShadeScratch::air for the segments that something dims or brightens; which.
    HitMask run()
    {
        if (!has_air(context_)) return 0;
        const HitMask in_air = in_some_air(), hollow = in_air != 0 ? find_hollow(in_air) : 0;
        if (hollow == 0) return 0;
        if (context_.traits.even_fog) return hollow & fog_tile();
        along(hollow);
        return hollow;
    }

private:
    /// Those of the segments with nothing solid around them.
    HitMask find_hollow(HitMask asked) const
    {
        const std::vector<plan::Interior>& interiors = context_.scene.interiors;
        const auto hollow = [&](std::size_t k) { return tile_.interiors(k).all_hollow(interiors); };
        asked &= first_hits(tile_.count());
        if (asked == 0 || tile_.all_open()) return asked;
        if (tile_.alike()) return hollow(0) ? asked : 0;
        HitMask all = 0;
        for_each_hit(asked, [&](std::size_t k) { all |= static_cast<HitMask>(hollow(k)) << k; });
        return all;
    }

    /// Segments that something may fill: all, or where it is but media of interiors those that are inside of one.
    HitMask in_some_air() const
    {
        const plan::CompiledScene& scene = context_.scene;
        if (!scene.fogs.empty() || !scene.rainbows.empty() || !scene.atmosphere.empty() ||
            !scene.options.lean.takes(plan::LeanStep::Interiors))
            return ~HitMask{0};
        bool& in_media = context_.scratch.shade.in_media;
        if (tile_.is_queued() ? !in_media : tile_.all_outside()) return 0;
        in_media = true;
        if (tile_.alike()) return ~HitMask{0};
        HitMask inside = 0;
        for (std::size_t k = 0; k < static_cast<std::size_t>(tile_.count()); ++k)
            if (!tile_.interiors(k).empty()) inside |= HitMask{1} << k;
        return inside;
    }

    /// The same as along() of all segments where there is nothing but fog that is the same everywhere. Those that it
    /// changes: thin fog is not seen close by.
    [[gnu::noinline]] HitMask fog_tile()
    {
        using numbers::lanes::Double;
        ShadeScratch& scratch = context_.scratch.shade;
        alignas(64) TileLanes length = tile_.hits.t, passes;
        for_each_hit(first_hits(tile_.count()) & ~tile_.found(), [&](std::size_t k) { length[k] = kSkyDistance; });
        HitMask changed = 0;
        for (const texture::Fog& fog : context_.scene.fogs) {
            const glm::vec3 tint = (1.0f - fog.color.filter) + fog.color.filter * fog.color.rgb();
            const Double whole(0x1.ffffffp-1);  // from here on it is 1 in single precision
            const Double close(tint == glm::vec3(1) ? kUnseen * fog.distance : -1.0);
            HitMask seen = 0;
            for (int i = 0; i < tile_.count(); i += numbers::lanes::kDoubles) {
                if (numbers::lanes::mask(!(Double::load_aligned(length.data() + i) <= close)) == 0) continue;
                const Double a = fog_transmission(fog, Double::load_aligned(length.data() + i));
                a.store_aligned(passes.data() + i);
                seen |= HitMask{numbers::lanes::mask(!(a >= whole))} << i;
            }
            if (tint != glm::vec3(1)) seen = ~HitMask{0};
            seen &= first_hits(tile_.count());
            for_each_hit(seen & ~changed, [&](std::size_t k) { scratch.air[k] = Air(); });
            changed |= seen;
            for_each_hit(seen, [&](std::size_t k) {
                Air& air = scratch.air[k];
                const auto a = static_cast<float>(passes[k]);
                air.glow += (1.0f - a) * fog.color.rgb();
                air.share *= a * tint;
                air.clear = scene::grey(air.share);
            });
        }
        return changed;
    }

    /// From what the rays have met to their origins (spec 6, 1.6).
    [[gnu::noinline]] void along(HitMask hollow)
    {
        const plan::CompiledScene& scene = context_.scene;
        auto& air = context_.scratch.shade.air;
        for_each_hit(hollow, [&](std::size_t k) { air[k] = {}; });
        MediaStage media(context_, tile_);
        if (!scene.media.media.empty()) media.cross_interiors(hollow & tile_.found());
        tell<&Recorder::air>(context_.scratch.shade, hollow, RecordedAir::Effect::InteriorMedia);
        const auto length = [&](std::size_t k) { return has(tile_.found(), k) ? tile_.hits.t[k] : kSkyDistance; };
        if (!scene.rainbows.empty())
            for_each_hit(hollow, [&](std::size_t k) { air[k].behind(rainbow_air(context_, tile_.ray(k), length(k))); });
        tell<&Recorder::air>(context_.scratch.shade, hollow, RecordedAir::Effect::Rainbows);
        if (!scene.atmosphere.empty()) media.cross_atmosphere(hollow);
        tell<&Recorder::air>(context_.scratch.shade, hollow, RecordedAir::Effect::Media);
        if (scene.fogs.empty()) return;
        alignas(64) TileLanes lengths{};
        for_each_hit(hollow, [&](std::size_t k) { lengths[k] = length(k); });
        add_fogs(context_, tile_.rays, hollow, lengths, air);
    }

    Context& context_;
    const SegmentTile& tile_;
};

}  // namespace trace
