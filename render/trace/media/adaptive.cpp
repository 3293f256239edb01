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

/// Sample n of sub-interval i has the number n * jobs_ + i. The last of them lies before the end (spec 6, 2.7).
void AdaptiveSums::place_even()
{
    const double jitter = chunk_.control->jitter, gaps = static_cast<double>(gaps_) + 1.0;
    samples_.clear();
    for (std::uint32_t n = 0; n <= gaps_; ++n)
        for (std::uint32_t i = 0; i < jobs_; ++i) {
            double place = n / gaps;
            if (jitter != 0.0) place += jitter * (chunk_.random(i, n) - 0.5) / gaps;
            samples_.add(i, place);
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
    for (std::uint32_t n = 0; n < gaps_; ++n)
        for (std::uint32_t i = 0; i < jobs_; ++i) {
            const auto first = static_cast<std::uint32_t>(n * jobs_ + i),
                       last = static_cast<std::uint32_t>(first + jobs_);
            samples_.add(i, middle_of(first, last, i, n + 1));
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
        find(samples_.depth.*channel, scratch_.depth.*channel);
    }
}

/// Gaps whose samples differ so much that they are divided further.
void AdaptiveSums::find_divided()
{
    const std::size_t count = gaps_ * jobs_;
    scratch_.left.assign(count, MediaGap::kNone);
    scratch_.right.assign(count, MediaGap::kNone);
    const int level = chunk_.control->aa_level - 1;
    for (std::size_t g = 0; g < count; ++g) {
        const std::size_t last = g + jobs_, middle = g + middles_;
        const float threshold = chunk_.jobs[samples_.job[g]].mix->threshold;
        const glm::vec3 at_middle = samples_.light[middle];
        const bool left = apart(samples_.light[g], at_middle) > threshold,
                   right = apart(at_middle, samples_.light[last]) > threshold;
        if (!left && !right) continue;
        scratch_.divided.push_back(static_cast<std::uint32_t>(g));
        const auto number = 2u * (static_cast<std::uint32_t>(g / jobs_) + 1u + static_cast<std::uint32_t>(gaps_));
        const auto add = [&](std::size_t from, std::size_t to, std::uint32_t side) {
            scratch_.gaps.push_back(
                {static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to), level - 1, number + side});
            return static_cast<std::uint32_t>(scratch_.gaps.size() - 1);
        };
        if (left) scratch_.left[g] = add(g, middle, 0);
        if (right) scratch_.right[g] = add(middle, last, 1);
    }
}

/// Halves of halves, all of one depth together.
void AdaptiveSums::divide_all()
{
    std::vector<MediaGap>& gaps = scratch_.gaps;
    for (std::size_t first = 0; first < gaps.size();) {
        const std::size_t end = gaps.size(), before = samples_.size();
        for (std::size_t g = first; g < end; ++g) {
            MediaGap& gap = gaps[g];
            const std::uint8_t job = samples_.job[gap.first];
            gap.middle = samples_.add(job, middle_of(gap.first, gap.last, job, gap.number));
        }
        sampler_.evaluate(before);
        for (std::size_t g = first; g < end; ++g) {
            const MediaGap gap = gaps[g];
            if (gap.level <= 0) continue;
            const float threshold = chunk_.jobs[samples_.job[gap.first]].mix->threshold;
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
            depth += gaps[inner].depth * 0.5f;
        } else {
            light += samples_.light[end] * kThird + samples_.light[middle] * kSixth;
            depth += samples_.depth[end] * kThird + samples_.depth[middle] * kSixth;
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
        scratch_.depth.set(g, depth);
    }
}

/// Gaps of each sub-interval one behind the other, in the medium of those before.
void AdaptiveSums::sum()
{
    const float share = 1.0f / static_cast<float>(gaps_);
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

}  // namespace trace
