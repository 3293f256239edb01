#include "render/kernel/media/sampled_sums.h"

#include "render/kernel/media/media_sampler.h"

#include <algorithm>

namespace trace {

void SampledSums::run()
{
    const auto jobs = static_cast<std::size_t>(chunk_.count);
    for (std::size_t i = 0; i < jobs; ++i) {
        chunk_.light[i] = chunk_.depth[i] = squares_[i] = glm::vec3(0);
        chunk_.taken[i] = 0;
    }
    place_least();
    sampler_.evaluate(0);
    for (std::size_t s = 0; s < samples_.size(); ++s) add(samples_.job[s], s);
    asking_.clear();
    if (chunk_.control->enough.empty()) return;
    for (std::size_t i = 0; i < jobs; ++i) asking_.push_back(static_cast<std::uint32_t>(i));
    for (;;) {
        std::erase_if(asking_, [this](std::uint32_t i) { return !uncertain(i); });
        if (asking_.empty()) return;
        const std::size_t first = samples_.size();
        for (const std::uint32_t i : asking_)
            samples_.add(i, chunk_.random(i, static_cast<std::uint32_t>(chunk_.taken[i])));
        sampler_.evaluate(first);
        for (std::size_t s = first; s < samples_.size(); ++s) add(samples_.job[s], s);
    }
}

/// Those that are taken in any case, the nearest of all sub-intervals first.
void SampledSums::place_least()
{
    const plan::Media& control = *chunk_.control;
    const bool even = control.method == plan::Media::Method::Even;
    const int least = control.samples_least;
    samples_.clear();
    samples_.told_depth = true;
    for (std::uint32_t n = 0; n < static_cast<std::uint32_t>(least); ++n)
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(chunk_.count); ++i) {
            double place = even ? (n + 0.5) / least : chunk_.random(i, n);
            if (even && control.jitter != 0.0) place += control.jitter * chunk_.random(i, n) / least;
            samples_.add(i, place);
        }
}

void SampledSums::add(std::size_t i, std::size_t sample)
{
    const glm::vec3 light = samples_.light[sample];
    chunk_.light[i] += light;
    squares_[i] += light * light;
    chunk_.depth[i] += samples_.depth[sample];
    ++chunk_.taken[i];
}

/// Whether one sample more is wanted: the variance of the mean is too large in some channel.
bool SampledSums::uncertain(std::size_t i) const
{
    const plan::Media& control = *chunk_.control;
    if (chunk_.taken[i] > control.samples_most) return false;
    const auto n = static_cast<double>(chunk_.taken[i]);
    const double bound = control.enough_after(static_cast<std::size_t>(chunk_.taken[i]));
    for (int c = 0; c < 3; ++c) {
        const double mean = static_cast<double>(chunk_.light[i][c]) / n;
        if ((static_cast<double>(squares_[i][c]) / n - mean * mean) / n >= bound) return true;
    }
    return false;
}

}  // namespace trace
