#include "render/kernel/media/media_stage.h"

#include "render/kernel/extinction/media_exp.h"
#include "render/kernel/media/media_photons.h"
#include "render/kernel/media/sampled_sums.h"
#include "numbers/random.h"
#include "render/plan/shines_on.h"
#include "render/kernel/media/media_scratch.h"

namespace trace {

MediaStage::MediaStage(Context& context, const SegmentTile& tile)
    : context_(context), shade_(context.scratch.shade), scratch_(context.scratch.media()), tile_(tile),
      sampler_(context, scratch_, tile)
{}

void MediaStage::cross(HitMask segments, bool atmosphere)
{
    scratch_.mix_count = 0;
    scratch_.segments.clear();
    scratch_.segments.reserve(csg::kTileRays);
    scratch_.mixes.reserve(csg::kTileRays + 1);
    const std::size_t lights = context_.scene.lights.lights.size();
    if (scratch_.lit.size() < lights) scratch_.lit.resize(lights);
    for (LitSegments& lit : scratch_.lit) lit.reached = 0;
    scratch_.pieces.clear();
    last_inside_ = nullptr;
    for_each_hit(segments, [&](std::size_t k) {
        if (const MediaMix* mix = mix_of(k, atmosphere)) add_segment(k, *mix);
    });
    next_ = ended_ = 0;
    while (take_parts()) {
        context_.scratch.geometry.cancel.look();  // a scene may ask for any number of intervals
        work_off();
        compose();
    }
    for (const MediaSegment& segment : scratch_.segments) {
        const glm::vec3 share = media_exp(-segment.depth);
        shade_.air[segment.lane].behind({share, segment.glow, scene::grey(share)});
    }
}

/// The media of segment k; null: none. Neighbours mostly have the same, so the last answer is kept.
const MediaMix* MediaStage::mix_of(std::size_t k, bool atmosphere)
{
    const InteriorList& inside = tile_.interiors(k);
    if (last_inside_ == nullptr || !(atmosphere || *last_inside_ == inside)) last_mix_ = find_mix(k, atmosphere);
    last_inside_ = &inside;
    return last_mix_;
}

const MediaMix* MediaStage::find_mix(std::size_t k, bool atmosphere)
{
    const plan::CompiledScene& scene = context_.scene;
    if (scratch_.mix_count == scratch_.mixes.size()) scratch_.mixes.emplace_back();
    MediaMix& fresh = scratch_.mixes[scratch_.mix_count];
    fresh.clear();
    if (atmosphere) fresh.add(scene.media, scene.atmosphere);
    else fresh.add(scene, tile_.interiors(k));
    if (fresh.count == 0) return nullptr;
    for (std::size_t i = scratch_.mix_count; i-- > 0;)
        if (scratch_.mixes[i].same_members(fresh)) return &scratch_.mixes[i];
    ++scratch_.mix_count;
    return &fresh;
}

void MediaStage::add_segment(std::size_t k, const MediaMix& mix)
{
    MediaSegment& segment = scratch_.segments.emplace_back();  // in place: a copy would wait for what was just written
    segment.ray = tile_.ray(k);
    segment.length = has(tile_.found(), k) ? tile_.hits.t[k] : kSkyDistance;
    segment.lane = static_cast<std::uint8_t>(k);
    segment.mix = &mix;
    if (mix.control->draws()) segment.seed = numbers::random_seed(segment.ray.origin, segment.ray.direction);
    segment.piece = static_cast<std::uint32_t>(scratch_.pieces.size());
    scratch_.ranges.clear();
    find_lit(segment);
    add_pieces(mix, segment.length, scratch_.ranges, scratch_.pieces);
    segment.last_piece = static_cast<std::uint32_t>(scratch_.pieces.size());
}

/// Finds where each light may reach the segment that was added last. Only lights that shine on the object at its end
/// count (spec 6, 2.4).
void MediaStage::find_lit(const MediaSegment& segment)
{
    const plan::CompiledScene& scene = context_.scene;
    const plan::Surface* end = has(tile_.found(), segment.lane) ? &scene.surfaces[tile_.hits.surface[segment.lane]]
                                                                : nullptr;
    const std::size_t at = scratch_.segments.size() - 1;
    for (std::size_t i = 0; i < context_.lights.lights.size(); ++i) {
        const light::Light& light = context_.lights.lights[i];
        LitSegments& lit = scratch_.lit[i];
        MediaRange& range = scratch_.ranges.emplace_back();  // in place, as above
        const bool shines = light.in_media && (end != nullptr ? shines_on(light, *end) : light.group == 0);
        if (!shines || !lit_range(light, segment.ray, segment.length, range)) {
            scratch_.ranges.pop_back();
            lit.from[at] = numbers::kInfinity;
            continue;
        }
        lit.reached |= HitMask{1} << at;
        lit.from[at] = range.from;
        lit.to[at] = range.to;
    }
}

/// Takes the next sub-intervals, from all segments in turn, so that their samples lie near each other. False: none are
/// left.
bool MediaStage::take_parts()
{
    constexpr std::size_t kMostParts = 1024;  // that need no samples
    scratch_.parts.clear();
    scratch_.chunk.clear();
    const auto& segments = scratch_.segments;
    while (ended_ < segments.size() && scratch_.parts.size() < kMostParts) {
        const MediaSegment& segment = segments[next_];
        if (segment.piece == segment.last_piece) {
            ++ended_;
        } else {
            ended_ = 0;
            const bool even = is_even(*segment.mix, scratch_.pieces[segment.piece].lit);
            if (!even && !scratch_.chunk.takes(*segment.mix->control)) break;
            take_part(next_);
        }
        next_ = next_ + 1 == segments.size() ? 0 : next_ + 1;
    }
    return !scratch_.parts.empty();
}

/// The next sub-interval of a segment.
void MediaStage::take_part(std::size_t number)
{
    MediaSegment& segment = scratch_.segments[number];
    const MediaPiece& piece = scratch_.pieces[segment.piece];
    // In place: a copy would wait for what was just written.
    MediaPart& part = scratch_.parts.emplace_back(static_cast<std::uint8_t>(number), MediaPart::kEven, piece.step);
    if (!is_even(*segment.mix, piece.lit)) {
        const MediaJob job{segment.mix, part.segment, segment.lane, piece.lit, segment.interval, segment.seed};
        const double from = piece.from + segment.part * piece.step;
        part.job = static_cast<std::uint8_t>(scratch_.chunk.add(job, segment.ray, from, piece.step));
    }
    ++segment.interval;
    if (++segment.part == piece.count) {
        ++segment.piece;
        segment.part = 0;
    }
}

/// Whether all samples of a sub-interval would have the same value, so that method 3 needs none.
bool MediaStage::is_even(const MediaMix& mix, bool lit) const
{
    return mix.control->method == plan::Media::Method::Adaptive && !mix.patterned &&
           !(mix.scatters && (lit || has_media_photons(context_)));
}

void MediaStage::work_off()
{
    MediaChunk& chunk = scratch_.chunk;
    if (chunk.count == 0) return;
    if (chunk.control->method == plan::Media::Method::Adaptive)
        AdaptiveSums(chunk, scratch_.samples, scratch_.adaptive, sampler_).run();
    else SampledSums(chunk, scratch_.samples, scratch_.asking, sampler_).run();
}

/// Adds the sub-intervals to their segments, nearest first, each dimmed by those before it.
void MediaStage::compose()
{
    for (const MediaPart& part : scratch_.parts) {
        MediaSegment& segment = scratch_.segments[part.segment];
        glm::vec3 light, depth;
        if (part.job == MediaPart::kEven) {
            AdaptiveSums::even(*segment.mix, part.step, light, depth);
        } else {
            const MediaChunk& chunk = scratch_.chunk;
            const float share = 1.0f / static_cast<float>(chunk.taken[part.job]);
            light = chunk.light[part.job] * share;
            depth = chunk.depth[part.job] * share;
        }
        if (light != glm::vec3(0)) segment.glow += light * media_exp(-segment.depth);
        segment.depth += depth;
    }
}

}  // namespace trace
