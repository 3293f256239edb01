#include "render/kernel/extinction/media_extinction.h"

#include "render/kernel/extinction/media_density.h"
#include "render/kernel/extinction/media_exp.h"
#include "numbers/random.h"

#include <algorithm>

namespace trace {
namespace {

using ShadowMethod = plan::Media::Method;

/// Optical depths of stretches from weighted points, a batch at a time. The sums don't depend on where batches end.
class DepthBatch {
public:
    DepthBatch(const plan::CompiledScene& scene, const MediaMix& mix) : scene_(scene), mix_(mix)
    {
        points_.density = true;
    }

    void add(const glm::dvec3& point, double weight, glm::vec3& depth)
    {
        weights_[points_.size()] = static_cast<float>(weight);
        depths_[points_.size()] = &depth;
        points_.add(point);
        if (points_.count == texture::kMostPoints) flush();
    }

    void flush()
    {
        if (points_.count == 0) return;
        points_.pad();
        TileColors extinction;
        extinction.fill(0.0f);
        for (std::size_t m = 0; m < mix_.count; ++m)
            if (mix_.members[m]->extinguishes()) add(*mix_.members[m], extinction);
        for (std::size_t k = 0; k < points_.size(); ++k) *depths_[k] += weights_[k] * extinction[k];
        points_.count = 0;
    }

private:
    void add(const plan::Media& media, TileColors& sum)
    {
        const TileColors* density = nullptr;
        if (media.densities != 0) density = &density_.at(scene_, media, points_, first_hits(points_.count));
        int c = 0;
        for (TileFloats TileColors::*channel : {&TileColors::red, &TileColors::green, &TileColors::blue}) {
            const float factor = media.extinction[c++];
            float* out = (sum.*channel).data();
            const float* in = density != nullptr ? (density->*channel).data() : nullptr;
            for (std::size_t k = 0; k < points_.size(); ++k) out[k] += in != nullptr ? factor * in[k] : factor;
        }
    }

    const plan::CompiledScene& scene_;
    const MediaMix& mix_;
    texture::Points points_;
    std::array<float, texture::kMostPoints> weights_;
    std::array<glm::vec3*, texture::kMostPoints> depths_;
    MediaDensity density_;
};

/// A stretch of a shadow ray as its samples are placed.
struct ShadowStretch {
    const csg::Ray& ray;
    double from, to;
    glm::vec3& depth;
    const glm::vec3* start = nullptr;  ///< extinction where it begins, if that is known
};

/// The samples of one sub-interval, with the weights that they get.
void add_samples(DepthBatch& batch, const plan::Media& control, std::uint64_t seed, std::uint32_t interval,
                 const ShadowStretch& at)
{
    const int least = control.samples_least;
    const double step = at.to - at.from;
    const auto random = [&](int n) { return numbers::random_of(seed, interval, static_cast<std::uint32_t>(n)); };
    const auto add = [&](double place, double weight) {
        batch.add(at.ray.at(at.from + place * step), weight, at.depth);
    };
    const bool jittered = control.jitter != 0.0;
    if (control.method == ShadowMethod::Random) {
        for (int n = 0; n < least; ++n) add(random(n), step / least);
        return;
    }
    if (control.method == ShadowMethod::Even) {
        for (int n = 0; n < least; ++n)
            add((n + 0.5) / least + (jittered ? control.jitter * random(n) / least : 0.0), step / least);
        return;
    }
    // Nothing is emitted, so no gap between samples is halved more than once.
    const int gaps = control.gaps();
    const double apart = 1.0 / control.gaps_to_end(), third = step / (3.0 * gaps);
    double before = 0.0;
    for (int n = 0; n <= gaps; ++n) {
        const double place = apart * (n + (jittered ? control.jitter * (random(2 * n) - 0.5) : 0.0));
        if (n > 0) {
            double middle = 0.5 * (before + place);
            if (jittered) middle += control.jitter * (place - before) * (random(2 * n + 1) - 0.5);
            add(middle, third);
        }
        if (n == 0 && at.start != nullptr && !jittered) at.depth += static_cast<float>(third) * *at.start;
        else add(place, n == 0 || n == gaps ? third : 2.0 * third);
        before = place;
    }
}

/// All sub-intervals of a stretch.
void add_stretch(DepthBatch& batch, const plan::Media& control, const ShadowStretch& at)
{
    const int intervals = control.has_density ? control.intervals : 1;
    const double step = (at.to - at.from) / intervals;
    const std::uint64_t seed = control.draws() ? numbers::random_seed(at.ray.at(at.from), at.ray.direction) : 0;
    for (int i = 0; i < intervals; ++i) {
        const double from = at.from + i * step;
        add_samples(batch, control, seed, static_cast<std::uint32_t>(i),
                    {at.ray, from, from + step, at.depth, i == 0 ? at.start : nullptr});
    }
}

/// Of media that are alike everywhere.
glm::vec3 even_extinction(const MediaMix& mix)
{
    glm::vec3 extinction(0);
    for (std::size_t m = 0; m < mix.count; ++m) extinction += mix.members[m]->extinction;
    return extinction;
}
glm::vec3 even_share(const glm::vec3& extinction, double length)
{
    return media_exp(-extinction * static_cast<float>(length));
}

}  // namespace

glm::vec3 media_share(const plan::CompiledScene& scene, const MediaMix& mix, const csg::Ray& ray, double from,
                      double to)
{
    if (!mix.extinguishes) return glm::vec3(1);
    if (!mix.patterned) return even_share(even_extinction(mix), to - from);
    glm::vec3 depth(0);
    DepthBatch batch(scene, mix);
    add_stretch(batch, *mix.control, {ray, from, to, depth});
    batch.flush();
    return media_exp(-depth);
}

bool MediaShadows::add_again(const InteriorList& inside, const csg::Ray& ray, double from, double to, std::size_t lane)
{
    if (!inside_known_ || !(inside_ == inside)) return false;
    put(inside_mix_, ray, from, to, lane);
    return true;
}

void MediaShadows::add(const InteriorList& inside, const MediaMix& mix, const csg::Ray& ray, double from, double to,
                       std::size_t lane)
{
    add(mix, ray, from, to, lane);
    inside_ = inside;
    inside_mix_ = stretches_.back().mix;
    inside_known_ = true;
}

void MediaShadows::add(const MediaMix& mix, const csg::Ray& ray, double from, double to, std::size_t lane)
{
    std::size_t i = mix_count_;
    while (i-- > 0 && !mixes_[i].same_members(mix)) {}
    if (i >= mix_count_) {
        i = mix_count_++;
        if (mixes_.size() < mix_count_) mixes_.emplace_back();
        mixes_[i] = mix;
    }
    put(static_cast<std::uint32_t>(i), ray, from, to, lane);
}

void MediaShadows::put(std::uint32_t mix, const csg::Ray& ray, double from, double to, std::size_t lane)
{
    Stretch& stretch = stretches_.emplace_back();
    stretch.ray = ray;
    stretch.from = from;
    stretch.to = to;
    stretch.mix = mix;
    stretch.lane = static_cast<std::uint8_t>(lane);
    if (from != 0.0 || starts_ == nullptr || !starts_->mixes[lane]->same_members(mixes_[mix])) return;
    stretch.start = starts_->extinction[lane];
    stretch.start_known = true;
}

void MediaShadows::find_depths(const plan::CompiledScene& scene)
{
    for (std::uint32_t m = 0; m < mix_count_; ++m) {
        DepthBatch batch(scene, mixes_[m]);
        for (Stretch& stretch : stretches_)
            if (stretch.mix == m)
                add_stretch(batch, *mixes_[m].control,
                            {stretch.ray, stretch.from, stretch.to, stretch.depth,
                             stretch.start_known ? &stretch.start : nullptr});
        batch.flush();
    }
}

/// media_exp() of all depths, in vector lanes.
void MediaShadows::find_shares()
{
    exponents_.clear();
    for (const Stretch& stretch : stretches_)
        for (int c = 0; c < 3; ++c) exponents_.push_back(stretch.depth[c]);
    for (float& e : exponents_) e = static_cast<float>(media_exp(-static_cast<double>(e)));
    const float* share = exponents_.data();
    for (Stretch& stretch : stretches_) {
        stretch.share = {share[0], share[1], share[2]};
        share += 3;
    }
}

glm::vec3 interior_media_share(const plan::CompiledScene& scene, const RayState& ray, double from, double to,
                               MediaShadows* later, std::size_t lane)
{
    // Neighbours are inside of the same, so the last answers come first.
    if (later != nullptr && later->add_again(ray.interiors, ray.ray, from, to, lane)) return glm::vec3(1);
    const glm::vec3* const even = later != nullptr ? later->even(ray.interiors) : nullptr;
    if (even != nullptr) return even_share(*even, to - from);
    bool dims = false;
    for (std::size_t i = 0; i < ray.interiors.size(); ++i) dims |= scene.interiors[ray.interiors[i]].media.extinguishes;
    if (!dims || !ray.interiors.all_hollow(scene.interiors)) return glm::vec3(1);
    MediaMix mix;
    mix.add(scene, ray.interiors);
    if (later == nullptr) return media_share(scene, mix, ray.ray, from, to);
    if (!mix.patterned) {
        later->keep_even(ray.interiors, even_extinction(mix));
        return even_share(*later->even(ray.interiors), to - from);
    }
    later->add(ray.interiors, mix, ray.ray, from, to, lane);
    return glm::vec3(1);
}

glm::vec3 atmosphere_media_share(const plan::CompiledScene& scene, const csg::Ray& ray, double from, double to,
                                 MediaShadows* later, std::size_t lane)
{
    if (!scene.atmosphere.extinguishes || !(to > from)) return glm::vec3(1);
    MediaMix mix;
    mix.add(scene.media, scene.atmosphere);
    if (later == nullptr || !mix.patterned) return media_share(scene, mix, ray, from, to);
    later->add(mix, ray, from, to, lane);
    return glm::vec3(1);
}

}  // namespace trace
