#include "render/trace/media/media_extinction.h"

#include "render/trace/media/media_mix.h"
#include "render/trace/media/media_samples.h"
#include "render/trace/random.h"

#include <algorithm>
#include <cmath>

namespace trace {
namespace {

using Method = plan::Media::Method;

/// Sums optical depth over weighted points of a ray, a batch at a time.
class DepthSum {
public:
    DepthSum(const plan::CompiledScene& scene, const MediaMix& mix, const csg::Ray& ray)
        : scene_(scene), mix_(mix), ray_(ray)
    {
        points_.count = 0;
    }

    void add(double t, double weight)
    {
        weights_[points_.size()] = static_cast<float>(weight);
        points_.add(ray_.at(t));
        if (points_.count == texture::kMostPoints) flush();
    }

    glm::vec3 sum()
    {
        flush();
        return sum_;
    }

private:
    void flush()
    {
        if (points_.count == 0) return;
        points_.pad();
        for (std::size_t m = 0; m < mix_.count; ++m) {
            const plan::Media& media = *mix_.members[m];
            if (!media.extinguishes()) continue;
            glm::vec3 density(0);
            if (media.densities != 0) {
                media_density(scene_, media, points_, colors_, density_);
                for (std::size_t k = 0; k < points_.size(); ++k) density += weights_[k] * density_[k];
            } else {
                for (std::size_t k = 0; k < points_.size(); ++k) density += weights_[k];
            }
            sum_ += density * media.extinction;
        }
        points_.count = 0;
    }

    const plan::CompiledScene& scene_;
    const MediaMix& mix_;
    const csg::Ray& ray_;
    texture::Points points_;
    std::array<float, texture::kMostPoints> weights_;
    texture::ColorPoints colors_;
    TileColors density_;
    glm::vec3 sum_{0};
};

glm::vec3 exp_of_negative(const glm::vec3& v)
{
    glm::vec3 out;
    for (int c = 0; c < 3; ++c) out[c] = static_cast<float>(std::exp(-static_cast<double>(v[c])));
    return out;
}

/// The samples of one sub-interval, with the weights that they get.
void add_samples(DepthSum& sum, const plan::Media& control, std::uint64_t seed, std::uint32_t interval, double from,
                 double step)
{
    const int least = control.samples_least;
    const auto random = [&](int n) { return random_of(seed, interval, static_cast<std::uint32_t>(n)); };
    const bool jittered = control.jitter != 0.0;
    if (control.method == Method::Random) {
        for (int n = 0; n < least; ++n) sum.add(from + random(n) * step, step / least);
        return;
    }
    if (control.method == Method::Even) {
        for (int n = 0; n < least; ++n) {
            const double place = (n + 0.5) / least + (jittered ? control.jitter * random(n) / least : 0.0);
            sum.add(from + place * step, step / least);
        }
        return;
    }
    // Nothing is emitted, so no gap between samples is halved more than once.
    const int gaps = std::max(2, least / 2 + 1);
    const double apart = 1.0 / (gaps + 1), third = step / (3.0 * gaps);
    double before = 0.0;
    for (int n = 0; n <= gaps; ++n) {
        const double place = apart * (n + (jittered ? control.jitter * (random(2 * n) - 0.5) : 0.0));
        if (n > 0) {
            double middle = 0.5 * (before + place);
            if (jittered) middle += control.jitter * (place - before) * (random(2 * n + 1) - 0.5);
            sum.add(from + middle * step, third);
        }
        sum.add(from + place * step, n == 0 || n == gaps ? third : 2.0 * third);
        before = place;
    }
}

}  // namespace

glm::vec3 media_share(const plan::CompiledScene& scene, const MediaMix& mix, const csg::Ray& ray, double from,
                      double to)
{
    if (!mix.extinguishes) return glm::vec3(1);
    const double length = to - from;
    if (!mix.patterned) {
        glm::vec3 extinction(0);
        for (std::size_t m = 0; m < mix.count; ++m) extinction += mix.members[m]->extinction;
        return exp_of_negative(extinction * static_cast<float>(length));
    }
    const plan::Media& control = *mix.control;
    const int intervals = control.has_density ? control.intervals : 1;
    const double step = length / intervals;
    const std::uint64_t seed = random_seed(ray.at(from), ray.direction);
    DepthSum sum(scene, mix, ray);
    for (int i = 0; i < intervals; ++i)
        add_samples(sum, control, seed, static_cast<std::uint32_t>(i), from + i * step, step);
    return exp_of_negative(sum.sum());
}

glm::vec3 interior_media_share(const plan::CompiledScene& scene, const RayState& ray, double from, double to)
{
    bool dims = false;
    for (std::size_t i = 0; i < ray.interiors.size(); ++i) dims |= scene.interiors[ray.interiors[i]].media.extinguishes;
    if (!dims || !ray.interiors.all_hollow(scene.interiors)) return glm::vec3(1);
    MediaMix mix;
    mix.add(scene, ray.interiors);
    return media_share(scene, mix, ray.ray, from, to);
}

}  // namespace trace
