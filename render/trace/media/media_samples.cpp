#include "render/trace/media/media_samples.h"

#include "render/trace/media/media_photons.h"
#include "render/trace/media/point_lights.h"

#include <algorithm>
#include <cmath>

namespace trace {
namespace {

/// Nothing that a density could look at: it has a place and no surface.
const texture::Surroundings kNoSurface{};

void add_scaled(TileColors& sum, const glm::vec3& by, const TileColors* density, HitMask which)
{
    if (by == glm::vec3(0)) return;
    int c = 0;
    for (TileFloats TileColors::*channel : {&TileColors::red, &TileColors::green, &TileColors::blue}) {
        const float factor = by[c++];
        float* out = (sum.*channel).data();
        const float* in = density != nullptr ? (density->*channel).data() : nullptr;
        for_each_hit(which, [&](std::size_t k) { out[k] += in != nullptr ? in[k] * factor : factor; });
    }
}

}  // namespace

void media_density(const plan::CompiledScene& scene, const plan::Media& media, const texture::Points& points,
                   texture::ColorPoints& colors, TileColors& density)
{
    texture::Around around;
    around.fill(&kNoSurface);
    const std::size_t count = points.size();
    for (std::uint32_t i = 0; i < media.densities; ++i) {
        texture::pigment_colors(scene.textures, scene.media.densities[media.first_density + i], points, around, colors);
        if (i == 0) {
            density.red = colors.red, density.green = colors.green, density.blue = colors.blue;
            continue;
        }
        for (std::size_t k = 0; k < count; ++k) {
            density.red[k] *= colors.red[k];
            density.green[k] *= colors.green[k];
            density.blue[k] *= colors.blue[k];
        }
    }
}

void MediaSampler::evaluate(std::size_t first)
{
    for (const std::size_t end = scratch_.samples.size(); first < end; first += csg::kTileRays)
        batch(first, std::min<std::size_t>(first + csg::kTileRays, end));
}

void MediaSampler::batch(std::size_t first, std::size_t last)
{
    MediaSamples& samples = scratch_.samples;
    const std::size_t count = last - first;
    scratch_.points.count = 0;
    HitMask scattering = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const MediaJob& job = scratch_.jobs[samples.job[first + k]];
        const MediaSegment& segment = scratch_.segments[job.segment];
        const double t = job.from + samples.place[first + k] * job.step;
        segments_[k] = &segment;
        mixes_[k] = &scratch_.mixes[segment.mix];
        scratch_.met.t[k] = t;
        scratch_.points.add(segment.ray.at(t));
        if (mixes_[k]->scatters) scattering |= HitMask{1} << k;
    }
    scratch_.points.pad();
    add_media(count);
    if (scattering != 0) add_light(first, last, scattering);
    for (std::size_t k = 0; k < count; ++k) {
        const MediaJob& job = scratch_.jobs[samples.job[first + k]];
        const auto step = static_cast<float>(job.step);
        const glm::vec3 extinction = extinction_[k];
        glm::vec3 light = emission_[k] * step;
        if (mixes_[k]->control->method != plan::Media::Method::Adaptive) {
            const double way = samples.place[first + k] * job.step;
            for (int c = 0; c < 3; ++c)
                light[c] *= static_cast<float>(std::exp(-static_cast<double>(extinction[c]) * way));
        }
        samples.light[first + k] = light;
        samples.depth[first + k] = extinction * step;
    }
}

/// Sums over the media at each point: coefficients times densities.
void MediaSampler::add_media(std::size_t count)
{
    emission_.fill(0.0f);
    scattering_.fill(0.0f);
    extinction_.fill(0.0f);
    std::size_t most = 0;
    for (std::size_t k = 0; k < count; ++k) most = std::max(most, mixes_[k]->count);
    const HitMask all = first_hits(static_cast<int>(count));
    for (std::size_t i = 0; i < most; ++i)
        for (HitMask left = all; left != 0;) {
            const MediaMix& mix = *mixes_[first_hit(left)];
            HitMask same = 0;
            const plan::Media* media = i < mix.count ? mix.members[i] : nullptr;
            for_each_hit(left, [&](std::size_t k) {
                const MediaMix& other = *mixes_[k];
                if ((i < other.count ? other.members[i] : nullptr) == media) same |= HitMask{1} << k;
            });
            left &= ~same;
            if (media == nullptr) continue;
            const TileColors* density = nullptr;
            if (media->densities != 0) {
                // All points of the batch are looked up: few are of other media.
                media_density(context_.scene, *media, scratch_.points, scratch_.colors, scratch_.density);
                density = &scratch_.density;
            }
            add_scaled(emission_, media->emission, density, same);
            add_scaled(scattering_, media->scattering, density, same);
            add_scaled(extinction_, media->extinction, density, same);
        }
}

/// Light of lamps and photons that turns into the rays.
void MediaSampler::add_light(std::size_t first, std::size_t last, HitMask scattering)
{
    const MediaSamples& samples = scratch_.samples;
    const auto& lights = context_.lights.lights;
    HitMask dense = 0, lit = 0;
    for_each_hit(scattering, [&](std::size_t k) {
        if (!(scattering_[k] == glm::vec3(0))) dense |= HitMask{1} << k;
        if (scratch_.jobs[samples.job[first + k]].lit) lit |= HitMask{1} << k;
    });
    lit &= dense;
    if (lit != 0) {
        Context own(context_, context_.scratch.nested());
        std::array<const InteriorList*, csg::kTileRays> around;
        for (std::size_t k = 0; k < last - first; ++k) around[k] = &tile_.interiors(segments_[k]->lane);
        if (own.scratch.shade.traits.surfaces.empty()) own.scratch.shade.traits = context_.scratch.shade.traits;
        PointLights points(own, scratch_.met, around, scratch_.points);
        PhotonShadow& caught = own.scratch.shade.photon_shadow;
        caught.scene = has_surface_photons(context_) ? &context_.scene : nullptr;
        caught.lit = lit;
        for (std::size_t i = 0; i < lights.size(); ++i) {
            HitMask asking = 0;
            for_each_hit(lit, [&](std::size_t k) {
                const auto segment = static_cast<std::size_t>(segments_[k] - scratch_.segments.data());
                const MediaRange& range = scratch_.lit[segment * lights.size() + i];
                const double t = scratch_.met.t[k];
                if (range.from <= t && t <= range.to) asking |= HitMask{1} << k;
            });
            if (asking == 0) continue;
            caught.of_light(i);
            for_each_hit(points.ask(lights[i], asking), [&](std::size_t k) {
                const double cosine = glm::dot(segments_[k]->ray.direction, points.direction(k));
                const auto turned = static_cast<float>(mixes_[k]->phase(cosine));
                emission_.set(k, emission_[k] + turned * scattering_[k] * points.color(k));
            });
        }
    }
    if (dense == 0 || !has_media_photons(context_)) return;
    std::array<glm::dvec3, csg::kTileRays> directions;
    for_each_hit(dense, [&](std::size_t k) { directions[k] = segments_[k]->ray.direction; });
    TileColors light;
    media_photons(context_, scratch_.points, dense, directions, mixes_, light);
    for_each_hit(dense, [&](std::size_t k) { emission_.set(k, emission_[k] + scattering_[k] * light[k]); });
}

}  // namespace trace
