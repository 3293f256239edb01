#include "render/kernel/media/adaptive.h"

#include "render/kernel/extinction/media_exp.h"
#include "render/kernel/media/media_sampler.h"

#include <algorithm>
#include <cmath>

namespace trace {
namespace {

constexpr float kThird = 1.0f / 3.0f, kSixth = 1.0f / 6.0f;
constexpr std::uint32_t kMiddles = 0x80000000u;  // numbers of samples in the middle of gaps begin here

/// What a gap of this depth leaves of light that comes from all over it alike: (1 - exp(-d)) / d.
glm::vec3 left_within(const glm::vec3& depth)
{
    constexpr float kShallow = 0.05f;  // below it the difference has too few digits
    const glm::vec3 left = media_exp(-depth);
    glm::vec3 out;
    for (int c = 0; c < 3; ++c) {
        const float d = depth[c];
        out[c] = std::abs(d) < kShallow ? 1.0f - d * (0.5f - d * (kSixth - d * (1.0f / 24.0f))) : (1.0f - left[c]) / d;
    }
    return out;
}

}  // namespace

void AdaptiveSums::even(const MediaMix& mix, double step, glm::vec3& light, glm::vec3& depth)
{
    glm::vec3 emission(0), extinction(0);
    for (std::size_t m = 0; m < mix.count; ++m) {
        emission += mix.members[m]->emission;
        extinction += mix.members[m]->extinction;
    }
    light = emission * static_cast<float>(step);
    depth = extinction * static_cast<float>(step);
    if (depth == glm::vec3(0) || light == glm::vec3(0)) return;
    if (mix.control->whole) {
        light *= left_within(depth);
        return;
    }
    const int gaps = mix.control->gaps();
    const glm::vec3 dimmed = media_exp(-depth / static_cast<float>(gaps));
    glm::vec3 sum(0), share(1);
    for (int n = 0; n < gaps; ++n) {
        sum += share;
        share *= dimmed;
    }
    light *= sum / static_cast<float>(gaps);
}

void AdaptiveSums::run()
{
    jobs_ = static_cast<std::size_t>(chunk_.count);
    gaps_ = static_cast<std::size_t>(chunk_.control->gaps());
    dims_ = !chunk_.one_mix || chunk_.jobs[0].mix->extinguishes;
    samples_.told_depth = dims_;
    place_even();
    sampler_.evaluate(0);
    place_middles();
    sampler_.evaluate(middles_);
    find_gaps();
    divided_ = 0;
    if (chunk_.control->aa_level > 1) find_divided();
    if (divided_ != 0) {
        divide_all();
        fold();
    }
    sum();
}

/// Places for one sample more of each sub-interval.
std::pair<std::uint8_t*, double*> AdaptiveSums::add_samples()
{
    const std::size_t first = samples_.grow(jobs_);
    return {samples_.job.data() + first, samples_.place.data() + first};
}

/// Sample n of sub-interval i has the number n * jobs_ + i. Before POV-Ray 3.8 the last of them lies before the end
/// (spec 6, 2.7).
void AdaptiveSums::place_even()
{
    const double jitter = chunk_.control->jitter, gaps = chunk_.control->gaps_to_end();
    samples_.clear();
    for (std::uint32_t n = 0; n <= gaps_; ++n) {
        const double even = n / gaps;
        const auto [job, place] = add_samples();
        for (std::size_t i = 0; i < jobs_; ++i) {
            job[i] = static_cast<std::uint8_t>(i);
            place[i] = even;
        }
        if (jitter == 0.0) continue;
        for (std::size_t i = 0; i < jobs_; ++i) place[i] += jitter * (chunk_.random(i, n) - 0.5) / gaps;
    }
}

double AdaptiveSums::middle_of(std::uint32_t first, std::uint32_t last, std::size_t job, std::uint32_t number) const
{
    const double jitter = chunk_.control->jitter, low = samples_.place[first], high = samples_.place[last];
    const double middle = 0.5 * (low + high);
    return jitter == 0.0 ? middle : middle + jitter * (high - low) * (chunk_.random(job, kMiddles + number) - 0.5);
}

/// Gap n of sub-interval i has the number n * jobs_ + i, and so have its middles behind middles_.
void AdaptiveSums::place_middles()
{
    middles_ = samples_.size();
    for (std::uint32_t n = 0; n < gaps_; ++n) {
        const auto [job, place] = add_samples();
        const double *low = samples_.place.data() + n * jobs_, *high = low + jobs_;
        for (std::size_t i = 0; i < jobs_; ++i) {
            job[i] = static_cast<std::uint8_t>(i);
            place[i] = 0.5 * (low[i] + high[i]);
        }
        if (chunk_.control->jitter == 0.0) continue;
        for (std::uint32_t i = 0; i < jobs_; ++i) {
            const auto first = static_cast<std::uint32_t>(n * jobs_ + i);
            place[i] = middle_of(first, static_cast<std::uint32_t>(first + jobs_), i, n + 1);
        }
    }
}

void AdaptiveSums::find_gaps()
{
    const std::size_t count = gaps_ * jobs_;
    scratch_.light.at_least(count);
    scratch_.depth.at_least(count);
    const auto find = [&](const std::vector<float>& found, std::vector<float>& out) {
        const float *first = found.data(), *last = first + jobs_, *middle = first + middles_;
        float* to = out.data();
        for (std::size_t g = 0; g < count; ++g)
            to[g] = (first[g] * kThird + middle[g] * kSixth) + (last[g] * kThird + middle[g] * kSixth);
    };
    for (std::vector<float> MediaColors::*channel : {&MediaColors::red, &MediaColors::green, &MediaColors::blue}) {
        find(samples_.light.*channel, scratch_.light.*channel);
        if (dims_) find(samples_.depth.*channel, scratch_.depth.*channel);
    }
}

/// Of gap n of each sub-interval: whether its middle tells something else than its ends.
void AdaptiveSums::find_steps(std::size_t n, GapFlags& left, GapFlags& right) const
{
    const float* at[3][3];  // by channel: the first, the middle and the last sample
    int c = 0;
    for (std::vector<float> MediaColors::*channel : {&MediaColors::red, &MediaColors::green, &MediaColors::blue}) {
        const float* first = (samples_.light.*channel).data() + n * jobs_;
        at[c][0] = first, at[c][1] = first + middles_, at[c][2] = first + jobs_;
        ++c;
    }
    const auto apart_of = [&](std::size_t i, int from, int to) {
        const auto d = [&](int of) { return std::abs(at[of][from][i] - at[of][to][i]); };
        return d(0) + d(1) + d(2);
    };
    for (std::size_t i = 0; i < jobs_; ++i) {
        left[i] = apart_of(i, 0, 1) > threshold_[i] ? 1u : 0u;
        right[i] = apart_of(i, 1, 2) > threshold_[i] ? 1u : 0u;
    }
}

/// Gaps whose samples differ so much that they are divided further.
void AdaptiveSums::find_divided()
{
    MediaGaps& gaps = scratch_.gaps;
    for (std::size_t i = 0; i < jobs_; ++i) threshold_[i] = chunk_.jobs[i].mix->threshold;
    gaps.clear();
    gaps.reserve(gaps_ * jobs_);
    alignas(64) GapFlags left, right;
    std::size_t count = 0;
    for (std::size_t n = 0; n < gaps_; ++n) {
        find_steps(n, left, right);
        for (std::size_t i = 0; i < jobs_; ++i) {  // which of them is no branch: nobody could guess it
            gaps.first[count] = static_cast<std::uint32_t>(n * jobs_ + i);
            gaps.number[count] = static_cast<std::uint32_t>(n + 1);
            count += left[i] | right[i];
        }
    }
    divided_ = gaps.count = count;
    for (std::size_t g = 0; g < count; ++g) gaps.last[g] = gaps.first[g] + static_cast<std::uint32_t>(jobs_);
}

/// Means over the halves of gaps, and those halves that are divided again as gaps of their own, if any are.
template <class Middle>
void AdaptiveSums::halve(std::size_t begin, std::size_t end, bool again, Middle&& middle_of_gap)
{
    MediaGaps& gaps = scratch_.gaps;
    gaps.reserve(2 * (end - begin));
    std::uint32_t *const first = gaps.first.data(), *const last = gaps.last.data(), *const owner = gaps.owner.data();
    const auto mean_of = [](const MediaColors& found) {
        return [red = found.red.data(), green = found.green.data(), blue = found.blue.data()](std::uint32_t s) {
            return MediaMean{red[s], green[s], blue[s], 0.0f};
        };
    };
    const auto half = [](const MediaMean& side, const MediaMean& middle) {
        return MediaMean{side.red * kThird + middle.red * kSixth, side.green * kThird + middle.green * kSixth,
                         side.blue * kThird + middle.blue * kSixth, 0.0f};
    };
    const auto differ = [](const MediaMean& a, const MediaMean& b) {
        return std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue);
    };
    const auto light = mean_of(samples_.light), depth = mean_of(samples_.depth);
    std::size_t made = gaps.count;
    for (std::size_t g = begin; g < end; ++g) {
        const std::uint32_t from = first[g], to = last[g], middle = middle_of_gap(g);
        const MediaMean near = light(from), between = light(middle), far = light(to);
        gaps.half_light[2 * g] = half(near, between);
        gaps.half_light[2 * g + 1] = half(far, between);
        if (!again) continue;
        const float threshold = threshold_[samples_.job[from]];
        first[made] = from, last[made] = middle, owner[made] = static_cast<std::uint32_t>(2 * g);
        made += differ(near, between) > threshold ? 1u : 0u;
        first[made] = middle, last[made] = to, owner[made] = static_cast<std::uint32_t>(2 * g + 1);
        made += differ(between, far) > threshold ? 1u : 0u;
    }
    if (dims_)
        for (std::size_t g = begin; g < end; ++g) {
            const MediaMean between = depth(middle_of_gap(g));
            gaps.half_depth[2 * g] = half(depth(first[g]), between);
            gaps.half_depth[2 * g + 1] = half(depth(last[g]), between);
        }
    if (chunk_.control->jitter != 0.0)
        for (std::size_t g = gaps.count; g < made; ++g)
            gaps.number[g] = 2u * (gaps.number[owner[g] / 2] + static_cast<std::uint32_t>(gaps_)) + owner[g] % 2;
    gaps.count = made;
}

/// Halves of halves, all of one depth together.
void AdaptiveSums::divide_all()
{
    MediaGaps& gaps = scratch_.gaps;
    int level = chunk_.control->aa_level - 1;
    halve(0, divided_, true, [&](std::size_t g) { return gaps.first[g] + static_cast<std::uint32_t>(middles_); });
    for (std::size_t begin = divided_; begin < gaps.count;) {
        const std::size_t end = gaps.count, before = samples_.grow(end - begin);
        for (std::size_t g = begin; g < end; ++g) samples_.job[before + (g - begin)] = samples_.job[gaps.first[g]];
        const double* place = samples_.place.data();
        double* middle = samples_.place.data() + before;
        if (chunk_.control->jitter == 0.0)
            for (std::size_t g = begin; g < end; ++g)
                middle[g - begin] = 0.5 * (place[gaps.first[g]] + place[gaps.last[g]]);
        else
            for (std::size_t g = begin; g < end; ++g)
                middle[g - begin] = middle_of(gaps.first[g], gaps.last[g], samples_.job[gaps.first[g]], gaps.number[g]);
        sampler_.evaluate(before);
        halve(begin, end, --level > 0, [&](std::size_t g) { return static_cast<std::uint32_t>(before + (g - begin)); });
        begin = end;
    }
}

/// What divided halves say, the last made first; then the gaps that they belong to.
void AdaptiveSums::fold()
{
    const MediaGaps& gaps = scratch_.gaps;
    const auto fold_all = [&](std::vector<MediaMean>& halves, MediaColors& out) {
        const auto both = [&](std::size_t g) {
            const MediaMean &a = halves[2 * g], &b = halves[2 * g + 1];
            return MediaMean{0.0f + a.red + b.red, 0.0f + a.green + b.green, 0.0f + a.blue + b.blue, 0.0f};
        };
        for (std::size_t g = gaps.count; g-- > divided_;) {
            const MediaMean sum = both(g);
            halves[gaps.owner[g]] = {sum.red * 0.5f, sum.green * 0.5f, sum.blue * 0.5f, 0.0f};
        }
        for (std::size_t g = 0; g < divided_; ++g) {
            const MediaMean sum = both(g);
            out.set(gaps.first[g], {sum.red, sum.green, sum.blue});
        }
    };
    fold_all(scratch_.gaps.half_light, scratch_.light);
    if (dims_) fold_all(scratch_.gaps.half_depth, scratch_.depth);
}

/// Gaps of each sub-interval one behind the other, in the medium of those before; since POV-Ray 3.8 in their own too
/// (spec 7d, 2).
void AdaptiveSums::sum()
{
    const float share = 1.0f / static_cast<float>(gaps_);
    if (!dims_) return sum_undimmed();
    for (std::size_t i = 0; i < jobs_; ++i) {
        glm::vec3 light(0), depth(0);
        for (std::size_t n = 0; n < gaps_; ++n) {
            const glm::vec3 here = scratch_.light[n * jobs_ + i];
            const glm::vec3 own = scratch_.depth[n * jobs_ + i];
            if (here != glm::vec3(0)) {
                const glm::vec3 left = media_exp(-depth * share);
                light += here * (chunk_.control->whole ? left * left_within(own * share) : left);
            }
            depth += own;
        }
        chunk_.light[i] = light;
        chunk_.depth[i] = depth;
        chunk_.taken[i] = static_cast<int>(gaps_);
    }
}

/// The same of media that take no light.
void AdaptiveSums::sum_undimmed()
{
    alignas(64) TileColors sums;
    const auto add_up = [&](const std::vector<float>& from, TileFloats& to) {
        to.fill(0.0f);
        for (std::size_t n = 0; n < gaps_; ++n)
            for (std::size_t i = 0; i < jobs_; ++i) to[i] += from[n * jobs_ + i];
    };
    add_up(scratch_.light.red, sums.red);
    add_up(scratch_.light.green, sums.green);
    add_up(scratch_.light.blue, sums.blue);
    for (std::size_t i = 0; i < jobs_; ++i) {
        chunk_.light[i] = sums[i];
        chunk_.depth[i] = glm::vec3(0);
        chunk_.taken[i] = static_cast<int>(gaps_);
    }
}

}  // namespace trace
