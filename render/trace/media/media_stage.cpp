#include "render/trace/media/media_stage.h"

#include "render/trace/media/media_photons.h"
#include "render/trace/random.h"

#include <algorithm>
#include <cmath>

namespace trace {
namespace {

using Method = plan::Media::Method;

glm::vec3 exp_of(const glm::vec3& v)
{
    return {static_cast<float>(std::exp(static_cast<double>(v.x))),
            static_cast<float>(std::exp(static_cast<double>(v.y))),
            static_cast<float>(std::exp(static_cast<double>(v.z)))};
}

/// How far apart two contributions are.
float apart(const glm::vec3& a, const glm::vec3& b)
{
    return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z);
}

constexpr std::uint32_t kMiddles = 0x80000000u;  // numbers of samples in the middle of gaps begin here

}  // namespace

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
    for_each_hit(segments, [&](std::size_t k) {
        if (const MediaMix* mix = find_mix(k, atmosphere)) add_segment(k, *mix);
    });
    next_ = ended_ = 0;
    while (take_jobs()) work_off();
    for (const MediaSegment& segment : scratch_.segments) {
        const glm::vec3 share = exp_of(-segment.depth);
        shade_.air[segment.lane].behind({share, segment.glow, scene::grey(share)});
    }
}

/// The media of segment k; null: none. Neighbours as a rule have the same.
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
    MediaSegment segment;
    segment.ray = tile_.ray(k);
    segment.length = has(tile_.found(), k) ? tile_.hits.t[k] : kSkyDistance;
    segment.lane = static_cast<std::uint8_t>(k);
    segment.mix = &mix;
    segment.seed = random_seed(segment.ray.origin, segment.ray.direction);
    segment.piece = static_cast<std::uint32_t>(scratch_.pieces.size());
    scratch_.ranges.clear();
    find_lit(segment);
    add_pieces(mix, segment.length, scratch_.ranges, scratch_.pieces);
    segment.last_piece = static_cast<std::uint32_t>(scratch_.pieces.size());
    scratch_.segments.push_back(segment);
}

/// Where each light may reach the segment: those that the object that ends it is lit by (spec 6, 2.4).
void MediaStage::find_lit(const MediaSegment& segment)
{
    const plan::CompiledScene& scene = context_.scene;
    const plan::Surface* end = has(tile_.found(), segment.lane) ? &scene.surfaces[tile_.hits.surface[segment.lane]]
                                                                : nullptr;
    const std::size_t at = scratch_.segments.size();
    for (std::size_t i = 0; i < context_.lights.lights.size(); ++i) {
        const light::Light& light = context_.lights.lights[i];
        LitSegments& lit = scratch_.lit[i];
        MediaRange range;
        const bool shines = light.in_media && (end != nullptr ? shines_on(light, *end) : light.group == 0);
        if (!shines || !lit_range(light, segment.ray, segment.length, range)) {
            lit.from[at] = csg::kInfinity;
            continue;
        }
        scratch_.ranges.push_back(range);
        lit.reached |= HitMask{1} << at;
        lit.from[at] = range.from;
        lit.to[at] = range.to;
    }
}

/// The next sub-intervals, those of all segments in turn, so that their samples lie near each other. False: no more.
bool MediaStage::take_jobs()
{
    scratch_.jobs.clear();
    auto& segments = scratch_.segments;
    while (scratch_.jobs.size() < csg::kTileRays && ended_ < segments.size()) {
        MediaSegment& segment = segments[next_];
        if (segment.piece == segment.last_piece) {
            ++ended_;
        } else {
            ended_ = 0;
            const MediaPiece& piece = scratch_.pieces[segment.piece];
            MediaJob job;
            job.segment = &segment;
            job.interval = segment.interval++;
            job.from = piece.from + segment.part * piece.step;
            job.step = piece.step;
            job.lit = piece.lit;
            scratch_.jobs.push_back(job);
            if (++segment.part == piece.count) {
                ++segment.piece;
                segment.part = 0;
            }
        }
        next_ = next_ + 1 == segments.size() ? 0 : next_ + 1;
    }
    return !scratch_.jobs.empty();
}

void MediaStage::work_off()
{
    scratch_.samples.clear();
    scratch_.order.clear();
    scratch_.gaps.clear();
    place_samples();
    sampler_.evaluate(0);
    take_more();
    divide_gaps();
    sum_gaps();
    compose();
}

/// A number that depends on the ray, the sub-interval and the sample.
double MediaStage::random(const MediaJob& job, std::uint32_t sample) const
{
    return random_of(job.segment->seed, job.interval, sample);
}

/// Every sample of the sub-interval tells the same.
bool MediaStage::is_even(const MediaJob& job) const
{
    const MediaMix& mix = *job.segment->mix;
    return mix.control->method == Method::Adaptive && !mix.patterned && !(mix.scatters && job.lit) &&
           !(mix.scatters && has_media_photons(context_));
}

/// The samples that a sub-interval has in any case, the nearest of all sub-intervals first.
void MediaStage::place_samples()
{
    int most = 0;
    std::size_t places = 0;
    for (MediaJob& job : scratch_.jobs) {
        const plan::Media& control = job.control();
        if (control.method == Method::Adaptive) {
            job.gaps = std::max(2, control.samples_least / 2 + 1);
            job.even = is_even(job);
            job.taken = job.even ? 1 : job.gaps + 1;
        } else {
            job.taken = control.samples_least;
        }
        job.first = static_cast<std::uint32_t>(places);
        places += static_cast<std::size_t>(job.taken);
        most = std::max(most, job.taken);
    }
    scratch_.order.resize(places);
    for (int n = 0; n < most; ++n)
        for (std::uint32_t i = 0; i < scratch_.jobs.size(); ++i) {
            const MediaJob& job = scratch_.jobs[i];
            if (n >= job.taken) continue;
            const plan::Media& control = job.control();
            const auto number = static_cast<std::uint32_t>(n);
            const double jitter = control.jitter;
            double place = 0.0;
            switch (control.method) {
            case Method::Random: place = random(job, number); break;
            case Method::Even:
                place = (n + 0.5) / job.taken;
                if (jitter != 0.0) place += jitter * random(job, number) / job.taken;
                break;
            case Method::Adaptive:
                place = n / (job.gaps + 1.0);
                if (jitter != 0.0) place += jitter * (random(job, number) - 0.5) / (job.gaps + 1.0);
                break;
            }
            scratch_.order[job.first + number] = scratch_.samples.add(i, place);
        }
}

/// Methods 1 and 2: sums, and samples at random while their variance is too large (spec 6, 2.7).
void MediaStage::take_more()
{
    const MediaSamples& samples = scratch_.samples;
    const auto add = [](MediaJob& job, const glm::vec3& light, const glm::vec3& depth) {
        job.sum += light;
        job.squares += light * light;
        job.depths += depth;
    };
    std::vector<std::uint32_t>& asking = scratch_.asking;
    asking.clear();
    for (std::uint32_t i = 0; i < scratch_.jobs.size(); ++i) {
        MediaJob& job = scratch_.jobs[i];
        if (job.gaps != 0) continue;
        for (std::uint32_t n = 0; n < static_cast<std::uint32_t>(job.taken); ++n) {
            const std::uint32_t at = scratch_.order[job.first + n];
            add(job, samples.light[at], samples.depth[at]);
        }
        const plan::Media& control = job.control();
        if (!control.enough.empty() && job.taken < control.samples_most) asking.push_back(i);
    }
    const auto uncertain = [&](std::uint32_t i) {
        const MediaJob& job = scratch_.jobs[i];
        const plan::Media& control = job.control();
        if (job.taken > control.samples_most) return false;
        const auto n = static_cast<double>(job.taken);
        const double bound = control.enough_after(static_cast<std::size_t>(job.taken));
        for (int c = 0; c < 3; ++c) {
            const double mean = static_cast<double>(job.sum[c]) / n;
            if ((static_cast<double>(job.squares[c]) / n - mean * mean) / n >= bound) return true;
        }
        return false;
    };
    for (;;) {
        std::erase_if(asking, [&](std::uint32_t i) { return !uncertain(i); });
        if (asking.empty()) return;
        const std::size_t first = samples.size();
        for (const std::uint32_t i : asking) {
            MediaJob& job = scratch_.jobs[i];
            scratch_.samples.add(i, random(job, static_cast<std::uint32_t>(job.taken++)));
        }
        sampler_.evaluate(first);
        for (std::size_t k = 0; k < asking.size(); ++k)
            add(scratch_.jobs[asking[k]], samples.light[first + k], samples.depth[first + k]);
    }
}

/// Method 3: gaps between samples are halved where the samples differ (spec 6, 2.7).
void MediaStage::divide_gaps()
{
    MediaSamples& samples = scratch_.samples;
    std::vector<MediaGap>& gaps = scratch_.gaps;
    int most = 0;
    for (MediaJob& job : scratch_.jobs) {
        if (job.gaps == 0 || job.even) continue;
        most = std::max(most, job.gaps);
    }
    for (int j = 0; j < most; ++j)
        for (const MediaJob& job : scratch_.jobs) {
            if (job.even || j >= job.gaps) continue;
            const std::uint32_t at = job.first + static_cast<std::uint32_t>(j);
            const plan::Media& control = job.control();
            gaps.push_back(
                {scratch_.order[at], scratch_.order[at + 1], control.aa_level - 1, static_cast<std::uint32_t>(j) + 1u});
        }
    for (std::size_t first = 0; first < gaps.size();) {
        const std::size_t end = gaps.size(), before = samples.size();
        for (std::size_t g = first; g < end; ++g) {
            MediaGap& gap = gaps[g];
            const std::uint32_t owner = samples.job[gap.first];
            const MediaJob& job = scratch_.jobs[owner];
            const plan::Media& control = job.control();
            const double low = samples.place[gap.first], high = samples.place[gap.last];
            double place = 0.5 * (low + high);
            if (control.jitter != 0.0)
                place += control.jitter * (high - low) * (random(job, kMiddles + gap.number) - 0.5);
            gap.middle = samples.add(owner, place);
        }
        sampler_.evaluate(before);
        for (std::size_t g = first; g < end; ++g) {
            const MediaGap gap = gaps[g];
            if (gap.level <= 0) continue;
            const MediaJob& job = scratch_.jobs[samples.job[gap.first]];
            const auto threshold = static_cast<float>(job.segment->mix->threshold);
            const auto divide = [&](std::uint32_t MediaGap::*half, std::uint32_t from, std::uint32_t to,
                                    std::uint32_t side) {
                if (!(apart(samples.light[from], samples.light[to]) > threshold)) return;
                gaps[g].*half = static_cast<std::uint32_t>(gaps.size());
                const std::uint32_t number = 2u * (gap.number + static_cast<std::uint32_t>(job.gaps)) + side;
                gaps.push_back({from, to, gap.level - 1, number});
            };
            divide(&MediaGap::left, gap.first, gap.middle, 0);
            divide(&MediaGap::right, gap.middle, gap.last, 1);
        }
        first = end;
    }
}

/// Gaps that were made last first; then the sums of each sub-interval.
void MediaStage::sum_gaps()
{
    const MediaSamples& samples = scratch_.samples;
    std::vector<MediaGap>& gaps = scratch_.gaps;
    constexpr float kThird = 1.0f / 3.0f, kSixth = 1.0f / 6.0f;
    for (std::size_t g = gaps.size(); g-- > 0;) {
        MediaGap& gap = gaps[g];
        const auto half = [&](std::uint32_t inner, std::uint32_t end) {
            if (inner != MediaGap::kNone) {
                gap.light += gaps[inner].light * 0.5f;
                gap.depth += gaps[inner].depth * 0.5f;
            } else {
                gap.light += samples.light[end] * kThird + samples.light[gap.middle] * kSixth;
                gap.depth += samples.depth[end] * kThird + samples.depth[gap.middle] * kSixth;
            }
        };
        half(gap.left, gap.first);
        half(gap.right, gap.last);
    }
    // Gaps between samples come first in the list, those of all sub-intervals in turn, the nearest first.
    std::size_t g = 0;
    int most = 0;
    for (const MediaJob& job : scratch_.jobs) most = std::max(most, job.gaps);
    for (int j = 0; j < most; ++j)
        for (MediaJob& job : scratch_.jobs) {
            if (j >= job.gaps) continue;
            const float share = 1.0f / static_cast<float>(job.gaps);
            const glm::vec3 dimmed = exp_of(-job.depths * share);
            if (job.even) {
                const std::uint32_t only = scratch_.order[job.first];
                job.sum += samples.light[only] * dimmed;
                job.depths += samples.depth[only];
            } else {
                job.sum += gaps[g].light * dimmed;
                job.depths += gaps[g++].depth;
            }
        }
    for (MediaJob& job : scratch_.jobs)
        if (job.gaps != 0) job.taken = job.gaps;
}

/// Sub-intervals of each segment one behind the other.
void MediaStage::compose()
{
    for (const MediaJob& job : scratch_.jobs) {
        MediaSegment& segment = *job.segment;
        const float share = 1.0f / static_cast<float>(job.taken);
        segment.glow += job.sum * share * exp_of(-segment.depth);
        segment.depth += job.depths * share;
    }
}

}  // namespace trace
