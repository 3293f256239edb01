#include "render/trace/media/adaptive.h"

#include "render/trace/media/media_exp.h"
#include "render/trace/media/media_sampler.h"

#include <algorithm>
#include <cmath>

namespace trace {
namespace {

constexpr float kThird = 1.0f / 3.0f, kSixth = 1.0f / 6.0f;
constexpr std::uint32_t kMiddles = 0x80000000u;  // numbers of samples in the middle of gaps begin here

/// How far apart two contributions are.
float apart(const glm::vec3& a, const glm::vec3& b)
{
    return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z);
}

}  // namespace

int AdaptiveSums::gaps_of(const plan::Media& control) { return std::max(2, control.samples_least / 2 + 1); }

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
    const int gaps = gaps_of(*mix.control);
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
    gaps_ = static_cast<std::size_t>(gaps_of(*chunk_.control));
    dims_ = !chunk_.one_mix || chunk_.jobs[0].mix->extinguishes;
    place_even();
    sampler_.evaluate(0);
    place_middles();
    sampler_.evaluate(middles_);
    find_gaps();
    scratch_.gaps.clear();
    scratch_.divided.clear();
    if (chunk_.control->aa_level > 1) find_divided();
    if (!scratch_.gaps.empty()) {
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

/// Sample n of sub-interval i has the number n * jobs_ + i. The last of them lies before the end (spec 6, 2.7).
void AdaptiveSums::place_even()
{
    const double jitter = chunk_.control->jitter, gaps = static_cast<double>(gaps_) + 1.0;
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
    scratch_.light.resize(count);
    scratch_.depth.resize(count);
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
    scratch_.left.assign(gaps_ * jobs_, MediaGap::kNone);
    scratch_.right.assign(gaps_ * jobs_, MediaGap::kNone);
    for (std::size_t i = 0; i < jobs_; ++i) threshold_[i] = chunk_.jobs[i].mix->threshold;
    const int level = chunk_.control->aa_level - 1;
    alignas(64) GapFlags left, right;
    for (std::size_t n = 0; n < gaps_; ++n) {
        find_steps(n, left, right);
        const auto number = 2u * static_cast<std::uint32_t>(n + 1 + gaps_);
        for (std::size_t i = 0; i < jobs_; ++i) {
            if ((left[i] | right[i]) == 0) continue;
            const std::size_t g = n * jobs_ + i, last = g + jobs_, middle = g + middles_;
            scratch_.divided.push_back(static_cast<std::uint32_t>(g));
            const auto add = [&](std::size_t from, std::size_t to, std::uint32_t side) {
                scratch_.gaps.push_back(
                    {static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to), level - 1, number + side});
                return static_cast<std::uint32_t>(scratch_.gaps.size() - 1);
            };
            if (left[i] != 0) scratch_.left[g] = add(g, middle, 0);
            if (right[i] != 0) scratch_.right[g] = add(middle, last, 1);
        }
    }
}

/// Halves of halves, all of one depth together.
void AdaptiveSums::divide_all()
{
    std::vector<MediaGap>& gaps = scratch_.gaps;
    for (std::size_t first = 0; first < gaps.size();) {
        const std::size_t end = gaps.size(), before = samples_.grow(end - first);
        for (std::size_t g = first; g < end; ++g) {
            MediaGap& gap = gaps[g];
            const std::uint8_t job = samples_.job[gap.first];
            const std::size_t at = before + (g - first);
            gap.middle = static_cast<std::uint32_t>(at);
            samples_.job[at] = job;
            samples_.place[at] = middle_of(gap.first, gap.last, job, gap.number);
        }
        sampler_.evaluate(before);
        for (std::size_t g = first; g < end; ++g) {
            const MediaGap gap = gaps[g];
            if (gap.level <= 0) continue;
            const float threshold = threshold_[samples_.job[gap.first]];
            const std::uint32_t number = 2u * (gap.number + static_cast<std::uint32_t>(gaps_));
            const auto divide = [&](std::uint32_t MediaGap::*half, std::uint32_t from, std::uint32_t to,
                                    std::uint32_t side) {
                if (!(apart(samples_.light[from], samples_.light[to]) > threshold)) return;
                gaps[g].*half = static_cast<std::uint32_t>(gaps.size());
                gaps.push_back({from, to, gap.level - 1, number + side});
            };
            divide(&MediaGap::left, gap.first, gap.middle, 0);
            divide(&MediaGap::right, gap.middle, gap.last, 1);
        }
        first = end;
    }
}

/// What divided halves say, the last made first; then the gaps that they belong to.
void AdaptiveSums::fold()
{
    std::vector<MediaGap>& gaps = scratch_.gaps;
    const auto half = [&](std::uint32_t inner, std::uint32_t end, std::uint32_t middle, glm::vec3& light,
                          glm::vec3& depth) {
        if (inner != MediaGap::kNone) {
            light += gaps[inner].light * 0.5f;
            if (dims_) depth += gaps[inner].depth * 0.5f;
        } else {
            light += samples_.light[end] * kThird + samples_.light[middle] * kSixth;
            if (dims_) depth += samples_.depth[end] * kThird + samples_.depth[middle] * kSixth;
        }
    };
    for (std::size_t g = gaps.size(); g-- > 0;) {
        MediaGap& gap = gaps[g];
        half(gap.left, gap.first, gap.middle, gap.light, gap.depth);
        half(gap.right, gap.last, gap.middle, gap.light, gap.depth);
    }
    for (const std::uint32_t g : scratch_.divided) {
        glm::vec3 light(0), depth(0);
        const auto middle = static_cast<std::uint32_t>(g + middles_);
        half(scratch_.left[g], g, middle, light, depth);
        half(scratch_.right[g], static_cast<std::uint32_t>(g + jobs_), middle, light, depth);
        scratch_.light.set(g, light);
        if (dims_) scratch_.depth.set(g, depth);
    }
}

/// Gaps of each sub-interval one behind the other, in the medium of those before.
void AdaptiveSums::sum()
{
    const float share = 1.0f / static_cast<float>(gaps_);
    if (!dims_) return sum_undimmed();
    for (std::size_t i = 0; i < jobs_; ++i) {
        glm::vec3 light(0), depth(0);
        for (std::size_t n = 0; n < gaps_; ++n) {
            const glm::vec3 here = scratch_.light[n * jobs_ + i];
            if (here != glm::vec3(0)) light += here * media_exp(-depth * share);
            depth += scratch_.depth[n * jobs_ + i];
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
