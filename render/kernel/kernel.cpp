#include "render/kernel/kernel.h"

#include "render/texture/function_host.h"
#include "render/kernel/camera/camera_rays.h"
#include "render/kernel/camera/focal_blur.h"
#include "render/kernel/tile/geometry.h"
#include "render/kernel/gather/indirect_light.h"
#include "render/kernel/photon/photon_tracer.h"
#include "render/kernel/context/shade_tile.h"
#include "render/kernel/context/context.h"
#include "render/kernel/interior/start_interiors.h"
#include "render/kernel/record/recorder.h"

#include <algorithm>
#include <limits>

// Given by the build: the instruction set that this copy is compiled for.
#ifndef WHITTLE_ISA
#error "WHITTLE_ISA names the kernel's instruction set"
#endif

namespace trace {
namespace {

/// A tile's samples such that neighbours in the list are neighbours in the picture: the bits of row and column in turn.
constexpr std::array<std::uint8_t, kTileRays> kNearInTile = [] {
    std::array<std::uint8_t, kTileRays> order{};
    for (unsigned k = 0; k < kTileRays; ++k) {
        const unsigned column = (k & 1u) | (k >> 1 & 2u) | (k >> 2 & 4u),
                       row = (k >> 1 & 1u) | (k >> 2 & 2u) | (k >> 3 & 4u);
        order[k] = static_cast<std::uint8_t>(kTileSide * row + column);
    }
    return order;
}();

}  // namespace

/// Traces blocks for one thread: samples to rays, rays to hits, hits to colours, a tile at a time.
class BlockTracer {
public:
    BlockTracer(const plan::CompiledScene& scene, const IndirectLight* indirect, const std::atomic<bool>* cancel)
        : scene_(scene), world_(scene.world()),
          camera_(scene.camera, scene.options.width, scene.options.height,
                  {scene.mesh_camera.get(), &scene.textures, scene.camera_normal, scene.camera_functions}),
          blur_(scene.camera, scene.textures, scene.bokeh), starts_(scene), context_(scene, scratch_, indirect)
    {
        scratch_.geometry.cancel = csg::CancelWatch(cancel);
        for (const std::uint32_t interior : scene.camera_interiors) first_.interiors.append(interior);
        // A perspective camera's tiles differ in nothing but their directions.
        rays_.ox.fill(scene.camera.location.x);
        rays_.oy.fill(scene.camera.location.y);
        rays_.oz.fill(scene.camera.location.z);
        rays_.t_min.fill(scene.tolerance.hit);
        rays_.t_max.fill(camera_.max_distance() > 0.0 ? camera_.max_distance() : numbers::kInfinity);
    }

    /// False: it was cancelled (Scratch's watch) in the middle of a tile, and the tracer can only be freed.
    bool trace(const Block& block, scene::Color* out)
    {
        const SampleTracer tracer{&grid, &few, this, scene_.options.grain_stream};
        try {
            antialias(scene_.options.antialiasing, scene_.settings.assumed_gamma, block, tracer, antialias_, out);
        } catch (const csg::Cancelled&) {
            return false;
        }
        return true;
    }

    /// trace() for samples that lie anywhere.
    bool sample(std::span<const SamplePosition> positions, scene::Color* out)
    {
        try {
            few(this, positions.data(), static_cast<int>(positions.size()), out);
        } catch (const csg::Cancelled&) {
            return false;
        }
        return true;
    }

    /// Traces a tile of a radiosity pass: its hits ask for indirect light, and the samples that this makes are handed
    /// back. Their colours are thrown away.
    bool pretrace(const radiosity::PassTile& tile, radiosity::TileFindings& out)
    {
        filling_.begin(*context_.indirect->radiosity, tile);
        context_.filling = &filling_;
        try {
            begin_tile();
            for (int i = 0; i < tile.count; ++i) add_sample(tile.at[static_cast<std::size_t>(i)], &unused_);
            make_rays();
            if (rays_.count > 0) trace_rays();
        } catch (const csg::Cancelled&) {
            return false;
        }
        context_.filling = nullptr;
        out.found = filling_.found;
        out.next = filling_.next;
        out.asked = 0;
        out.weight = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(rays_.count); ++i) {
            out.asked += filling_.asked[i];
            out.weight += static_cast<double>(filling_.weight[i]);
        }
        return true;
    }

    void record(Record* into)
    {
        recorder_.reset();
        if (into != nullptr) recorder_ = std::make_unique<Recorder>(scene_, scratch_.shade, *into);
    }

    RayCounts counts() const
    {
        RayCounts counts = scratch_.all_counts();
        counts.supersamples += antialias_.supersamples;
        return counts;
    }

private:
    /// Takes a grid of samples in strips about as wide as a tile, down and up in turn, so that tiles are compact and
    /// all but the last one full.
    static void grid(void* context, const SampleGrid& samples, scene::Color* out, std::size_t stride)
    {
        auto& self = *static_cast<BlockTracer*>(context);
        const bool one_by_one = self.scene_.options.grain_stream;  // as POV-Ray asks for random numbers
        const int strips = one_by_one ? 1 : std::max(1, (samples.columns + kTileSide / 2) / kTileSide),
                  most = one_by_one ? 1 : kTileRays;
        self.begin_tile();
        for (int strip = 0; strip < strips; ++strip) {
            const int left = samples.columns * strip / strips, right = samples.columns * (strip + 1) / strips;
            for (int n = 0; n < samples.rows; ++n) {
                const int row = strip % 2 == 0 ? n : samples.rows - 1 - n;
                scene::Color* const to = out + static_cast<std::size_t>(row) * stride;
                for (int column = left; column < right; ++column) {
                    self.add_sample(samples.first + SamplePosition(column, row), to + column);
                    if (self.samples_ < most) continue;
                    self.finish_tile();
                    self.begin_tile();
                }
            }
        }
        if (self.samples_ > 0) self.finish_tile();
    }

    static void few(void* context, const SamplePosition* positions, int count, scene::Color* out)
    {
        auto& self = *static_cast<BlockTracer*>(context);
        for (int first = 0; first < count; first += kTileRays) {
            self.begin_tile();
            for (int i = first; i < std::min(first + kTileRays, count); ++i) self.add_sample(positions[i], out + i);
            self.finish_tile();
        }
    }

    void begin_tile() { samples_ = 0; }

    void add_sample(const SamplePosition& p, scene::Color* out)
    {
        const auto k = static_cast<std::size_t>(samples_++);
        x_[k] = p.x;
        y_[k] = p.y;
        targets_[k] = out;
    }

    /// Makes the rays of the tile's samples: in vector lanes for a perspective or orthographic camera, else one by one.
    /// With other cameras not every sample has a ray.
    void make_rays()
    {
        rays_.common_origin = camera_.common_origin();
        rays_.count = samples_;
        if (camera_.flat_projection() && camera_.perspective(x_.data(), y_.data(), rays_)) return;
        if (camera_.is_parallel() && camera_.parallel(x_.data(), y_.data(), rays_)) {
            for (int i = 0; i < samples_; ++i) starts_.find(static_cast<std::size_t>(i), rays_.ray(i).origin);
            return;
        }
        rays_.count = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(samples_); ++i) {
            csg::Ray ray;
            if (!camera_.ray(x_[i], y_[i], ray)) {
                *targets_[i] = {0, 0, 0, 0, 1};  // no ray: black, and clear where alpha is asked for (spec 2, 4.10)
                continue;
            }
            targets_[static_cast<std::size_t>(rays_.count)] = targets_[i];
            put(rays_.count++, ray);
        }
    }

    void finish_tile()
    {
        if (blur_.active()) return finish_blurred();
        if (camera_.rays_per_sample() > 1) return finish_averaged();
        make_rays();
        if (rays_.count == 0) return;
        trace_rays();
        for (std::size_t i = 0; i < static_cast<std::size_t>(rays_.count); ++i) *targets_[i] = colors_[i];
    }

    /// Gives each sample the mean of its rays; a tile has one ray of every sample.
    void finish_averaged()
    {
        std::array<FocalBlur::Sums, kTileRays> sums{};
        std::array<std::size_t, kTileRays> owner{};
        rays_.common_origin = false;
        for (int k = 0; k < camera_.rays_per_sample(); ++k) {
            rays_.count = 0;
            for (std::size_t i = 0; i < static_cast<std::size_t>(samples_); ++i) {
                csg::Ray ray;
                if (!camera_.ray(x_[i], y_[i], ray, k)) continue;
                owner[static_cast<std::size_t>(rays_.count)] = i;
                put(rays_.count++, ray);
            }
            // Prefetches what the next rays need while these are traced.
            if (k + 1 < camera_.rays_per_sample())
                for (std::size_t i = 0; i < static_cast<std::size_t>(samples_); ++i) camera_.fetch(x_[i], y_[i], k + 1);
            if (rays_.count > 0) trace_rays();
            for (std::size_t i = 0; i < static_cast<std::size_t>(rays_.count); ++i)
                sums[owner[i]].add(colors_[i], true);
        }
        for (std::size_t i = 0; i < static_cast<std::size_t>(samples_); ++i)
            *targets_[i] = sums[i].count > 0 ? sums[i].mean() : scene::Color{0, 0, 0, 0, 1};
    }

    /// Samples of the tile in batches, each until it is certain; rays of different samples share tiles. All that go on
    /// have as many.
    void finish_blurred()
    {
        sums_.fill({});
        clouded_.fill(false);
        std::array<int, kTileRays> going;
        int left = 0;
        for (const std::uint8_t i : kNearInTile)
            if (i < samples_) going[static_cast<std::size_t>(left++)] = i;
        rays_.common_origin = false;
        waiting_.count = 0;
        for (int taken = 0; left > 0;) {
            const int more = blur_.batch(taken);
            for (int g = 0; g < left; ++g) {
                const int i = going[static_cast<std::size_t>(g)];
                for (int n = taken; n < taken + more; ++n) {
                    const auto at = static_cast<std::size_t>(waiting_.count++);
                    waiting_.x[at] = x_[static_cast<std::size_t>(i)];
                    waiting_.y[at] = y_[static_cast<std::size_t>(i)];
                    waiting_.n[at] = n;
                    owner_[at] = i;
                    if (waiting_.count == kTileRays) trace_waiting();
                }
            }
            trace_waiting();
            taken += more;
            int kept = 0;
            for (int g = 0; g < left; ++g) {
                const int i = going[static_cast<std::size_t>(g)];
                const FocalBlur::Sums& of = sums_[static_cast<std::size_t>(i)];
                if (blur_.batch(taken) > 0 && !blur_.converged(of)) going[static_cast<std::size_t>(kept++)] = i;
                else *targets_[static_cast<std::size_t>(i)] = of.mean();
            }
            left = kept;
        }
    }

    void trace_waiting()
    {
        const int count = waiting_.count;
        if (count == 0) return;
        if (!starts_.asked() && blur_.rays(camera_, waiting_, rays_)) {
            trace_rays();
        } else {
            rays_.count = 0;
            for (int i = 0; i < count; ++i) place_waiting(static_cast<std::size_t>(i));
            if (rays_.count > 0) trace_rays();
        }
        for (std::size_t i = 0; i < static_cast<std::size_t>(rays_.count); ++i)
            sums_[static_cast<std::size_t>(owner_[i])].add(colors_[i], true);
        waiting_.count = 0;
    }

    /// A sample without a ray is done.
    void place_waiting(std::size_t i)
    {
        const auto k = static_cast<std::size_t>(owner_[i]);
        csg::Ray ray;
        const bool has_ray = blur_.ray(camera_, {waiting_.x[i], waiting_.y[i]}, waiting_.n[i], ray);
        starts_.find(static_cast<std::size_t>(rays_.count), ray.origin, clouded_[k]);
        if (!has_ray) {
            tell<&Recorder::no_ray>(scratch_.shade);
            return sums_[k].add({0, 0, 0, 0, 1}, false);
        }
        owner_[static_cast<std::size_t>(rays_.count)] = owner_[i];
        place(rays_.count++, ray);
    }

    void put(int i, const csg::Ray& ray)
    {
        place(i, ray);
        starts_.find(static_cast<std::size_t>(i), ray.origin);
    }

    void place(int i, const csg::Ray& ray)
    {
        const auto k = static_cast<std::size_t>(i);
        rays_.ox[k] = ray.origin.x;
        rays_.oy[k] = ray.origin.y;
        rays_.oz[k] = ray.origin.z;
        rays_.dx[k] = ray.direction.x;
        rays_.dy[k] = ray.direction.y;
        rays_.dz[k] = ray.direction.z;
    }

    void trace_rays()
    {
        scratch_.counts.camera += static_cast<std::uint64_t>(rays_.count);
        world_.nearest(rays_, bit(plan::RayKind::Image), scratch_.geometry, hits_);
        shade_tile(context_, rays_, hits_, first_, starts_.lists(), colors_);
    }

    const plan::CompiledScene& scene_;
    csg::World world_;
    CameraRays camera_;
    FocalBlur blur_;
    StartInteriors starts_;
    Scratch scratch_;
    Context context_;
    RayState first_;  ///< what camera rays inherit
    AntialiasScratch antialias_;
    radiosity::Filling filling_;
    scene::Color unused_;
    alignas(64) std::array<double, kTileRays> x_{}, y_{};  ///< sample positions of the tile at hand
    int samples_ = 0;
    FocalBlur::Waiting waiting_;
    std::array<FocalBlur::Sums, kTileRays> sums_{};  ///< of a blurred tile's positions
    std::array<bool, kTileRays> clouded_{};
    std::array<int, kTileRays> owner_{};  ///< by ray of a blurred tile: its position
    RayTile rays_;
    HitTile hits_;
    scene::Color colors_[kTileRays];
    std::array<scene::Color*, kTileRays> targets_;
    std::unique_ptr<Recorder> recorder_;
};

namespace {

const KernelTable kTable = {
    WHITTLE_ISA,
    [](const plan::CompiledScene& scene, const IndirectLight* indirect, const std::atomic<bool>* cancel) {
        return new BlockTracer(scene, indirect, cancel);
    },
    [](BlockTracer* tracer) { delete tracer; },
    [](BlockTracer& tracer, const Block& block, scene::Color* out) { return tracer.trace(block, out); },
    [](BlockTracer& tracer, std::span<const SamplePosition> positions, scene::Color* out) {
        return tracer.sample(positions, out);
    },
    [](BlockTracer& tracer, const radiosity::PassTile& tile, radiosity::TileFindings& out) {
        return tracer.pretrace(tile, out);
    },
    [](const BlockTracer& tracer) { return tracer.counts(); },
    [](BlockTracer& tracer, Record* into) { tracer.record(into); },
    [](const plan::CompiledScene& scene, const std::atomic<bool>* cancel) { return new PhotonTracer(scene, cancel); },
    [](PhotonTracer* tracer) { delete tracer; },
    [](PhotonTracer& tracer, const PhotonFlight& flight, std::span<const Emission> photons, const JitterStream* jitter,
       PhotonYield& out) {
        return jitter != nullptr ? tracer.follow(flight, photons, *jitter, out) : tracer.count(flight, photons, out);
    },
    [](const plan::CompiledScene& scene, const path::Sources& sources, const std::atomic<bool>* cancel) {
        return new PathTracer(scene, sources, cancel);
    },
    [](PathTracer* tracer) { delete tracer; },
    [](PathTracer& tracer, std::span<const PathSample> samples, PathFound* out) { return tracer.trace(samples, out); },
    [](PathTracer& tracer, std::span<const PathSample> samples, FirstHit* out) {
        return tracer.find_first_hits(samples, out);
    },
    [](const PathTracer& tracer) { return tracer.counts(); },
    [](const csg::InsideLines& of, const csg::LineTile& lines, csg::ChordTile& out) { of.chords(lines, out); },
    texture::evaluators(),
};

}  // namespace
}  // namespace trace

extern "C" __attribute__((visibility("default"))) const trace::KernelTable* whittle_kernel() { return &trace::kTable; }
