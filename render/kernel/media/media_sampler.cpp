#include "render/kernel/media/media_sampler.h"

#include "render/kernel/extinction/media_exp.h"
#include "render/kernel/media/media_photons.h"
#include "render/kernel/media/point_lights.h"
#include "render/kernel/tile/lane_masks.h"
#include "render/kernel/extinction/shadow_media.h"

#include <algorithm>
#include <cmath>

namespace trace {
namespace {

constexpr auto kInOrder = [] {
    std::array<std::uint8_t, csg::kTileRays> jobs{};
    for (std::size_t k = 0; k < jobs.size(); ++k) jobs[k] = static_cast<std::uint8_t>(k);
    return jobs;
}();

/// Adds coefficients times densities; nothing for the density: 1.
void add_scaled(TileColors& sum, const glm::vec3& by, const TileColors* density, const LaneMask& which)
{
    if (by == glm::vec3(0)) return;
    int c = 0;
    for (TileFloats TileColors::*channel : {&TileColors::red, &TileColors::green, &TileColors::blue}) {
        const float factor = by[c++];
        float* out = (sum.*channel).data();
        if (density == nullptr) {
            for (std::size_t k = 0; k < csg::kTileRays; ++k) out[k] = which[k] != 0 ? out[k] + factor : out[k];
        } else {
            const float* in = (density->*channel).data();
            for (std::size_t k = 0; k < csg::kTileRays; ++k) out[k] = which[k] != 0 ? out[k] + in[k] * factor : out[k];
        }
    }
}

}  // namespace

void MediaSampler::evaluate(std::size_t first)
{
    MediaSamples& samples = scratch_.samples;
    const std::size_t end = samples.size();
    samples.light.at_least(end);
    samples.depth.at_least(end);
    for (; first < end; first += csg::kTileRays) batch(first, std::min<std::size_t>(csg::kTileRays, end - first));
}

void MediaSampler::batch(std::size_t first, std::size_t count)
{
    place(first, count);
    add_media();
    add_light();
    if (scratch_.chunk.control->method != plan::Media::Method::Adaptive) dim(first, count);
    keep(first, count);
}

/// Points of the samples.
void MediaSampler::place(std::size_t first, std::size_t count)
{
    const MediaChunk& chunk = scratch_.chunk;
    job_ = scratch_.samples.job.data() + first;
    const double* at = scratch_.samples.place.data() + first;
    texture::Points& points = scratch_.points;
    points.count = static_cast<int>(count);
    points.density = true;
    all_ = first_hits(points.count);
    const auto put = [&](std::size_t k, std::size_t i) {
        const double t = chunk.from[i] + at[k] * chunk.step[i];
        scratch_.met.t[k] = t;
        points.x[k] = chunk.ox[i] + t * chunk.dx[i];
        points.y[k] = chunk.oy[i] + t * chunk.dy[i];
        points.z[k] = chunk.oz[i] + t * chunk.dz[i];
        step_[k] = static_cast<float>(chunk.step[i]);
    };
    // The even samples of a full chunk.
    const bool in_order = std::equal(job_, job_ + count, kInOrder.data());
    if (in_order)
        for (std::size_t k = 0; k < count; ++k) put(k, k);
    else
        for (std::size_t k = 0; k < count; ++k) put(k, job_[k]);
    points.pad();
    one_mix_ = chunk.one_mix;
}

/// Sums over the media at each point: coefficients times densities.
void MediaSampler::add_media()
{
    emission_.fill(0.0f);
    scattered_.fill(0.0f);
    extinction_.fill(0.0f);
    std::size_t most = job(0).mix->count;
    if (!one_mix_) for_each_hit(all_, [&](std::size_t k) { most = std::max(most, job(k).mix->count); });
    for (std::size_t i = 0; i < most; ++i)
        for (HitMask left = all_; left != 0;) {
            const auto member = [&](std::size_t k) {
                const MediaMix& mix = *job(k).mix;
                return i < mix.count ? mix.members[i] : nullptr;
            };
            const plan::Media* media = member(first_hit(left));
            HitMask same = left;
            if (!one_mix_)
                for_each_hit(left, [&](std::size_t k) {
                    if (member(k) != media) same &= ~(HitMask{1} << k);
                });
            left &= ~same;
            if (media == nullptr) continue;
            const TileColors* density = nullptr;
            if (media->densities != 0) density = &scratch_.density.at(context_.scene, *media, scratch_.points, same);
            const LaneMask which(same);
            add_scaled(emission_, media->emission, density, which);
            add_scaled(scattered_, media->scattering, density, which);
            add_scaled(extinction_, media->extinction, density, which);
        }
}

/// Light of lamps and photons that turns into the rays.
void MediaSampler::add_light()
{
    HitMask dense = 0, lit = 0;
    if (one_mix_ && !job(0).mix->scatters) return;
    for_each_hit(all_, [&](std::size_t k) {
        if (!(scattered_[k] == glm::vec3(0))) dense |= HitMask{1} << k;
        if (job(k).lit) lit |= HitMask{1} << k;
    });
    if ((lit & dense) != 0) add_lamps(lit & dense);
    if (dense == 0 || !has_media_photons(context_)) return;
    std::array<glm::dvec3, csg::kTileRays> directions;
    std::array<const MediaMix*, csg::kTileRays> mixes;
    for_each_hit(dense, [&](std::size_t k) {
        directions[k] = scratch_.chunk.ray(job_[k]).direction;
        mixes[k] = job(k).mix;
    });
    TileColors light;
    media_photons(context_, scratch_.points, dense, directions, mixes, light);
    for_each_hit(dense, [&](std::size_t k) { emission_.set(k, emission_[k] + scattered_[k] * light[k]); });
}

void MediaSampler::add_lamps(HitMask lit)
{
    const auto& lights = context_.lights.lights;
    Context own(context_, context_.scratch.nested());
    std::array<const InteriorList*, csg::kTileRays> around;
    MediaStarts starts{extinction_, {}};
    HitMask segments = 0;
    for_each_hit(lit, [&](std::size_t k) {
        around[k] = &tile_.interiors(job(k).lane);
        starts.mixes[k] = job(k).mix;
        segments |= HitMask{1} << job(k).segment;
    });
    MediaShadows& shadows = own.scratch.shadow_media().shadows;
    shadows.start_at(&starts);
    PointLights points(own, scratch_.met, around, scratch_.points, lit);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const LitSegments& reach = scratch_.lit[i];
        if ((reach.reached & segments) == 0) continue;
        HitMask asking = 0;
        for_each_hit(lit, [&](std::size_t k) {
            const std::uint8_t s = job(k).segment;
            const double t = scratch_.met.t[k];
            const bool inside = reach.from[s] <= t && t <= reach.to[s];
            asking |= HitMask{inside ? 1u : 0u} << k;
        });
        if (asking == 0) continue;
        for_each_hit(points.ask(i, asking), [&](std::size_t k) {
            const double cosine = glm::dot(scratch_.chunk.ray(job_[k]).direction, points.direction(k));
            const auto turned = static_cast<float>(job(k).mix->phase(cosine));
            emission_.set(k, emission_[k] + turned * scattered_[k] * points.color(k));
        });
    }
    shadows.start_at(nullptr);
}

/// Methods 1 and 2: what lies before a sample in its sub-interval dims it.
void MediaSampler::dim(std::size_t first, std::size_t count)
{
    for (TileFloats TileColors::*channel : {&TileColors::red, &TileColors::green, &TileColors::blue})
        for (std::size_t k = 0; k < count; ++k) {
            float& light = (emission_.*channel)[k];
            if (light == 0.0f) continue;
            const double way = scratch_.samples.place[first + k] * scratch_.chunk.step[job_[k]];
            light *= static_cast<float>(media_exp(-static_cast<double>((extinction_.*channel)[k]) * way));
        }
}

/// Contributions and optical depths.
void MediaSampler::keep(std::size_t first, std::size_t count)
{
    const auto scale = [&](const TileFloats& found, std::vector<float>& out) {
        for (std::size_t k = 0; k < count; ++k) out[first + k] = found[k] * step_[k];
    };
    MediaSamples& samples = scratch_.samples;
    scale(emission_.red, samples.light.red);
    scale(emission_.green, samples.light.green);
    scale(emission_.blue, samples.light.blue);
    if (!samples.told_depth) return;
    scale(extinction_.red, samples.depth.red);
    scale(extinction_.green, samples.depth.green);
    scale(extinction_.blue, samples.depth.blue);
}

}  // namespace trace
