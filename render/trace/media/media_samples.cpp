#include "render/trace/media/media_samples.h"

#include "render/trace/media/media_photons.h"
#include "render/trace/media/point_lights.h"
#include "render/trace/queue/lane_masks.h"

#include <algorithm>
#include <cmath>

namespace trace {
namespace {

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
    samples.light.resize(end);
    samples.depth.resize(end);
    for (; first < end; first += csg::kTileRays) batch(first, std::min<std::size_t>(first + csg::kTileRays, end));
}

void MediaSampler::batch(std::size_t first, std::size_t last)
{
    place(first, last);
    add_media();
    if (scattering_ != 0) add_light();
    MediaSamples& samples = scratch_.samples;
    for (std::size_t k = 0; k < last - first; ++k) {
        const MediaJob& job = *jobs_[k];
        const auto step = static_cast<float>(job.step);
        const glm::vec3 extinction = extinction_[k];
        glm::vec3 light = emission_[k] * step;
        if (job.gaps == 0) {
            const double way = samples.place[first + k] * job.step;
            for (int c = 0; c < 3; ++c)
                if (light[c] != 0.0f)
                    light[c] *= static_cast<float>(std::exp(-static_cast<double>(extinction[c]) * way));
        }
        samples.light[first + k] = light;
        samples.depth[first + k] = extinction * step;
    }
}

/// Points of the samples.
void MediaSampler::place(std::size_t first, std::size_t last)
{
    const MediaSamples& samples = scratch_.samples;
    scratch_.points.count = 0;
    all_ = first_hits(static_cast<int>(last - first));
    scattering_ = 0;
    one_mix_ = true;
    for (std::size_t k = 0; k < last - first; ++k) {
        const MediaJob& job = scratch_.jobs[samples.job[first + k]];
        const double t = job.from + samples.place[first + k] * job.step;
        jobs_[k] = &job;
        scratch_.met.t[k] = t;
        scratch_.points.add(job.segment->ray.at(t));
        if (job.segment->mix->scatters) scattering_ |= HitMask{1} << k;
        one_mix_ = one_mix_ && job.segment->mix == jobs_[0]->segment->mix;
    }
    scratch_.points.pad();
}

/// Sums over the media at each point: coefficients times densities.
void MediaSampler::add_media()
{
    emission_.fill(0.0f);
    scattered_.fill(0.0f);
    extinction_.fill(0.0f);
    std::size_t most = 0;
    for_each_hit(all_, [&](std::size_t k) { most = std::max(most, jobs_[k]->segment->mix->count); });
    for (std::size_t i = 0; i < most; ++i)
        for (HitMask left = all_; left != 0;) {
            const auto member = [&](std::size_t k) {
                const MediaMix& mix = *jobs_[k]->segment->mix;
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
            if (media->densities != 0)
                density = &scratch_.density.at(context_.scene, *media, scratch_.points, same);
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
    for_each_hit(scattering_, [&](std::size_t k) {
        if (!(scattered_[k] == glm::vec3(0))) dense |= HitMask{1} << k;
        if (jobs_[k]->lit) lit |= HitMask{1} << k;
    });
    if ((lit & dense) != 0) add_lamps(lit & dense);
    if (dense == 0 || !has_media_photons(context_)) return;
    std::array<glm::dvec3, csg::kTileRays> directions;
    std::array<const MediaMix*, csg::kTileRays> mixes;
    for_each_hit(dense, [&](std::size_t k) {
        directions[k] = jobs_[k]->segment->ray.direction;
        mixes[k] = jobs_[k]->segment->mix;
    });
    TileColors light;
    media_photons(context_, scratch_.points, dense, directions, mixes, light);
    for_each_hit(dense, [&](std::size_t k) { emission_.set(k, emission_[k] + scattered_[k] * light[k]); });
}

void MediaSampler::add_lamps(HitMask lit)
{
    const auto& lights = context_.lights.lights;
    Context own(context_, context_.scratch.nested());
    if (own.scratch.shade.traits.surfaces.empty()) own.scratch.shade.traits = context_.scratch.shade.traits;
    std::array<const InteriorList*, csg::kTileRays> around;
    std::array<std::uint8_t, csg::kTileRays> segment;
    HitMask segments = 0;
    for_each_hit(lit, [&](std::size_t k) {
        around[k] = &tile_.interiors(jobs_[k]->segment->lane);
        segment[k] = static_cast<std::uint8_t>(jobs_[k]->segment - scratch_.segments.data());
        segments |= HitMask{1} << segment[k];
    });
    PointLights points(own, scratch_.met, around, scratch_.points);
    PhotonShadow& caught = own.scratch.shade.photon_shadow;
    caught.scene = has_surface_photons(context_) ? &context_.scene : nullptr;
    caught.lit = lit;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const LitSegments& reach = scratch_.lit[i];
        if ((reach.reached & segments) == 0) continue;
        HitMask asking = 0;
        for_each_hit(lit, [&](std::size_t k) {
            const std::uint8_t s = segment[k];
            const double t = scratch_.met.t[k];
            const bool inside = reach.from[s] <= t && t <= reach.to[s];
            asking |= HitMask{inside ? 1u : 0u} << k;
        });
        if (asking == 0) continue;
        caught.of_light(i);
        for_each_hit(points.ask(lights[i], asking), [&](std::size_t k) {
            const MediaSegment& of = *jobs_[k]->segment;
            const auto turned = static_cast<float>(of.mix->phase(glm::dot(of.ray.direction, points.direction(k))));
            emission_.set(k, emission_[k] + turned * scattered_[k] * points.color(k));
        });
    }
}

}  // namespace trace
