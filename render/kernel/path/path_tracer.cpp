#include "render/kernel/path/path_tracer.h"

#include "numbers/functions/functions.h"
#include "render/kernel/interior/interior_fade.h"
#include "render/kernel/air/air_stage.h"
#include "render/kernel/path/camera_start.h"
#include "render/kernel/path/lamp_rays.h"
#include "render/kernel/path/source_rays.h"
#include "render/kernel/path/surface.h"
#include "render/kernel/air/sky.h"
#include "render/kernel/tile/nearly_zero.h"

#include <algorithm>
#include <cmath>

namespace trace {
namespace path {
namespace {

constexpr int kSure = 3;              // bounces before a path may be ended by chance
constexpr double kMostLikely = 0.95;  // that one goes on, however much light it carries
constexpr int kMost = 10000;          // bounces: less than 1e-220 of what goes on gets here

/// Light that a body absorbs along a stretch of it (Beer-Lambert): as much over fade_distance as POV-Ray's fading
/// takes.
glm::vec3 absorbed(const plan::Interior& interior, double length)
{
    const auto reach = static_cast<double>(interior.fade_distance);
    if (!(std::abs(reach) > kNearlyZero) || !(interior.fade_power > 0.0f)) return glm::vec3(1);
    const glm::vec3 at_reach = interior_fade(interior, reach, false);
    glm::vec3 out;
    for (int k = 0; k < 3; ++k)
        out[k] = static_cast<float>(numbers::pow(std::max(0.0, static_cast<double>(at_reach[k])), length / reach));
    return out;
}

/// False: it was cancelled.
template <class Work>
bool ends_by_itself(Work work)
{
    try {
        work();
    } catch (const csg::Cancelled&) {
        return false;
    }
    return true;
}

bool finite(const glm::vec3& c) { return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z); }

}  // namespace
}  // namespace path

class PathTracer::Impl {
public:
    Impl(const plan::CompiledScene& scene, const path::Sources& sources, const std::atomic<bool>* cancel)
        : scene_(scene), world_(scene.world()), context_(scene, scratch_, nullptr), camera_(scene),
          faces_(has_air(context_) ? nullptr : &context_.lights), lamps_(context_, faces_),
          sources_(context_, sources.any() ? &sources : nullptr), reader_(context_, light_),
          alike_(world_.seen_by_all(static_cast<std::uint8_t>(
              bit(plan::RayKind::Image) | bit(plan::RayKind::Reflection) | bit(plan::RayKind::Gather))))
    {
        scratch_.geometry.cancel = csg::CancelWatch(cancel);
        sources_.set_air(has_air(context_));
        scratch_.shade.in_media = camera_.may_be_inside();
    }

    /// Ended paths make room for new ones, so that tiles stay full.
    void trace(std::span<const PathSample> samples, PathFound* out)
    {
        out_ = out;
        live_ = 0;
        std::size_t next = 0;
        do {
            for (; live_ < kTileRays && next < samples.size(); ++next) begin(samples[next], next);
            if (live_ > 0) step();
        } while (live_ > 0 || next < samples.size());
    }

    void find_first_hits(std::span<const PathSample> samples, FirstHit* out)
    {
        std::array<PathFound, kTileRays> unused;
        out_ = unused.data();
        for (std::size_t first = 0; first < samples.size(); first += kTileRays) {
            live_ = 0;
            const std::size_t count = std::min<std::size_t>(kTileRays, samples.size() - first);
            std::fill_n(out + first, count, FirstHit());
            for (std::size_t i = 0; i < count; ++i) begin(samples[first + i], i);
            if (live_ == 0) continue;
            const SegmentTile tile = meet_first(live_);
            for_each_hit(tile.found(), [&](std::size_t k) { out[first + walks_[k].owner] = seen(tile, k); });
        }
    }

    RayCounts counts() const { return scratch_.all_counts(); }

private:
    /// The segments' hits.
    SegmentTile meet_first(std::size_t count)
    {
        rays_.count = static_cast<int>(count);
        rays_.common_origin = false;
        for (std::size_t k = 0; k < count; ++k)
            rays_.set(k, segments_[k].state.ray, segments_[k].state.start,
                      walks_[k].bounces == 0 ? camera_.farthest() : numbers::kInfinity);
        world_.nearest(rays_, bit(segments_[0].state.kind), scratch_.geometry, hits_);
        return SegmentTile(context_, rays_, hits_, unused_, nullptr, segments_.data());
    }

    FirstHit seen(const SegmentTile& tile, std::size_t k)
    {
        const RayState& state = tile.state(k);
        const Hit met = tile.hits.at(static_cast<int>(k));
        const HitDetails details = world_.details(state.ray, met);
        HitContext hit = tile.context(k, state, met);
        hit.surround(details.point, details.uv);
        reader_.read(hit, details, walks_[k].draws);
        return {true,          met.t,          details.point,
                light_.normal, details.uv,     light_.bsdf.albedo() + light_.emission,
                met.surface,   tile.texture(k)};
    }

    void begin(const PathSample& sample, std::size_t owner)
    {
        path::Walk& walk = walks_[live_];
        walk = {};
        walk.draws = path::Draws(sample.seed, sample.index);
        walk.owner = owner;
        out_[owner] = {};
        if (!camera_.begin(sample, walk.draws, segments_[live_])) {
            out_[owner].color = {0, 0, 0, 0, 1};
            return;
        }
        ++scratch_.counts.camera;
        ++live_;
    }

    /// Brings rays of one kind to the front. How many.
    std::size_t gather_kind()
    {
        if (alike_) return live_;
        const plan::RayKind kind = segments_[0].state.kind;
        std::size_t count = 1;
        for (std::size_t k = 1; k < live_; ++k) {
            if (segments_[k].state.kind != kind) continue;
            if (k != count) {
                std::swap(segments_[k], segments_[count]);
                std::swap(walks_[k], walks_[count]);
            }
            ++count;
        }
        return count;
    }

    /// All paths at hand up to their next hit, and the light of that.
    void step()
    {
        const std::size_t count = gather_kind();
        const SegmentTile tile = meet_first(count);
        if (faces_.any()) meet_lamps(count);
        const HitMask dimmed = AirStage(context_, tile).run();
        for_each_hit(dimmed, [&](std::size_t k) {
            const Air& air = scratch_.shade.air[k];
            walks_[k].radiance += walks_[k].throughput * air.glow;
            walks_[k].throughput *= air.share;
        });
        goes_on_ = 0;
        const HitMask missed = first_hits(rays_.count) & ~tile.found();
        if (missed != 0) add_sky(tile, missed);
        lamps_.begin();
        sources_.begin();
        for_each_hit(tile.found(), [&](std::size_t k) { take_hit(tile, k); });
        const auto give = [&](std::size_t k, const glm::vec3& light) { walks_[k].radiance += light; };
        lamps_.run(give);
        sources_.run(give);
        keep(count);
    }

    /// Lamps that mirrors and bent light show to what has scattered the paths.
    void meet_lamps(std::size_t count)
    {
        for (std::size_t k = 0; k < count; ++k) {
            path::Walk& walk = walks_[k];
            if (!walk.chain.turned) continue;
            const RayState& state = segments_[k].state;
            const Hit met = hits_.at(static_cast<int>(k));
            const auto dim = [&](double t) {
                return state.interiors.empty() ? glm::vec3(1)
                                               : path::absorbed(scene_.interiors[state.interiors.last()], t);
            };
            walk.radiance += walk.throughput * faces_.met(state.ray, state.start,
                                                          met.found() ? met.t : numbers::kInfinity,
                                                          walk.length - walk.chain.begin, *walk.chain.from, dim);
        }
    }

    void add_sky(const SegmentTile& tile, HitMask missed)
    {
        std::array<scene::Color, kTileRays> sky;
        sky_colors(context_, tile, missed, sky.data());
        for_each_hit(missed, [&](std::size_t k) {
            path::Walk& walk = walks_[k];
            walk.radiance += walk.throughput * sky[k].rgb() *
                             sources_.weight_of_sky(walk.pdf, rays_.ray(static_cast<int>(k)).direction);
            out_[walk.owner].color.transmit = sky[k].transmit * std::min(1.0f, scene::grey(walk.throughput));
            if (!walk.seen) out_[walk.owner].albedo = sky[k].rgb();
        });
    }

    /// What the surface gives off, what a lamp adds to it, and how the path goes on.
    void take_hit(const SegmentTile& tile, std::size_t k)
    {
        path::Walk& walk = walks_[k];
        const RayState& state = tile.state(k);
        const Hit met = tile.hits.at(static_cast<int>(k));
        const HitDetails& details = tile.details(k);
        HitContext hit = tile.context(k, state, met);
        hit.surround(details.point, details.uv);
        if (!state.interiors.empty())
            walk.throughput *= path::absorbed(scene_.interiors[state.interiors.last()], met.t);
        walk.length += met.t;
        reader_.read(hit, details, walk.draws);
        if (!black(light_.emission))
            walk.radiance += walk.throughput * light_.emission * sources_.weight_of(walk.pdf, state.ray, met);
        if (light_.bsdf.scatters() || !black(light_.emission)) look_at(walk);
        if (light_.bsdf.scatters()) {
            lamps_.ask(k, hit, light_.bsdf, walk.throughput, walk.draws);
            if (sources_.asks(state.interiors)) sources_.ask(k, hit, light_.bsdf, walk.throughput, walk.draws);
        }
        const path::Scattered on = light_.bsdf.sample(walk.draws);
        if (on.lobe == nullptr) return;
        walk.throughput *= on.weight;
        ++walk.bounces;
        if (!path::finite(walk.throughput) || !survives(walk)) return;
        walk.pdf = sources_.asks(state.interiors) ? on.pdf : 0.0;
        if (!on.lobe->delta()) walk.chain = {&hit.surface, walk.length, false};
        else if (walk.chain.from != nullptr && turns(*on.lobe, hit.surface)) walk.chain.turned = true;
        next_[k] = next_ray(hit, on);
        goes_on_ |= HitMask{1} << k;
    }

    bool turns(const path::Lobe& lobe, const plan::Surface& surface) const
    {
        return lobe.kind == path::Lobe::Kind::Mirror || path::bends(scene_, surface);
    }

    /// The first surface that scatters light or has its own.
    void look_at(path::Walk& walk)
    {
        if (walk.seen) return;
        walk.seen = true;
        PathFound& out = out_[walk.owner];
        out.albedo = light_.bsdf.albedo() + light_.emission;
        out.normal = light_.normal;
        out.depth = static_cast<float>(walk.length);
    }

    /// Russian roulette: paths that carry little are ended by chance, the others carry more for it.
    static bool survives(path::Walk& walk)
    {
        const auto carried = static_cast<double>(largest(glm::abs(walk.throughput)));
        if (!(carried > 0.0) || walk.bounces >= path::kMost) return false;
        if (walk.bounces <= path::kSure) return true;
        const double chance = std::min(path::kMostLikely, carried);
        if (walk.draws.one() >= chance) return false;
        walk.throughput /= static_cast<float>(chance);
        return true;
    }

    RayState next_ray(const HitContext& hit, const path::Scattered& on)
    {
        using Kind = path::Lobe::Kind;
        if (on.lobe->kind == Kind::Through) {
            ++scratch_.counts.refracted;
            return light_.through.ray;
        }
        if (on.lobe->kind == Kind::Mirror) {
            ++scratch_.counts.reflected;
            return mirrored(context_, hit, on.lobe->normal, 1.0f);
        }
        ++scratch_.counts.gathered;
        RayState out;
        out.ray = {hit.point, on.direction};
        out.start = start_of(context_, hit, on.direction);
        out.kind = plan::RayKind::Gather;
        out.interiors = hit.state.interiors;
        out.wavelength = hit.state.wavelength;
        return out;
    }

    /// Paths that go on, and those that waited; the others are handed back.
    void keep(std::size_t traced)
    {
        std::size_t kept = 0;
        for (std::size_t k = 0; k < live_; ++k) {
            if (k < traced && !has(goes_on_, k)) {
                end(walks_[k]);
                continue;
            }
            if (k < traced) segments_[kept].state = next_[k];
            else if (k != kept) segments_[kept].state = segments_[k].state;
            if (k != kept) walks_[kept] = walks_[k];
            segments_[kept].level = 1;
            ++kept;
        }
        live_ = kept;
    }

    void end(const path::Walk& walk)
    {
        scene::Color& out = out_[walk.owner].color;
        const float transmit = out.transmit;
        out = scene::Color::of(path::finite(walk.radiance) ? walk.radiance : glm::vec3(0));
        out.transmit = transmit;
    }

    const plan::CompiledScene& scene_;
    csg::World world_;
    Scratch scratch_;
    Context context_;
    path::CameraStart camera_;
    const path::LampFaces faces_;
    path::LampRays lamps_;
    path::SourceRays sources_;
    path::SurfaceLight light_;  ///< of the hit at hand
    path::SurfaceReader reader_;
    const bool alike_;  ///< rays of all kinds see the same
    PathFound* out_ = nullptr;
    std::size_t live_ = 0;
    std::array<path::Walk, kTileRays> walks_;
    std::array<QueuedRay, kTileRays> segments_;
    std::array<RayState, kTileRays> next_;
    HitMask goes_on_ = 0;
    RayState unused_;
    RayTile rays_;
    HitTile hits_;
};

PathTracer::PathTracer(const plan::CompiledScene& scene, const path::Sources& sources, const std::atomic<bool>* cancel)
    : impl_(std::make_unique<Impl>(scene, sources, cancel))
{}
PathTracer::~PathTracer() = default;

bool PathTracer::trace(std::span<const PathSample> samples, PathFound* out)
{
    return path::ends_by_itself([&] { impl_->trace(samples, out); });
}

bool PathTracer::find_first_hits(std::span<const PathSample> samples, FirstHit* out)
{
    return path::ends_by_itself([&] { impl_->find_first_hits(samples, out); });
}

RayCounts PathTracer::counts() const { return impl_->counts(); }

}  // namespace trace
