#include "render/picture/passes/photon_pass.h"

#include "render/picture/kernel_module.h"
#include "render/picture/workers.h"
#include "render/picture/passes/photon_aim.h"
#include "render/picture/passes/photon_file.h"
#include "render/picture/passes/prepared.h"
#include "render/kernel/photon/photon_tracer.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace trace {
namespace {

/// A light and one of the targets that it shoots photons at.
struct PhotonUnit {
    std::size_t light, target;
};

/// The pairs between which photons are shot at all, in POV-Ray's order.
std::vector<PhotonUnit> units_of(const plan::CompiledScene& scene)
{
    const plan::PhotonPlan& plan = *scene.photons;
    std::vector<PhotonUnit> units;
    for (std::size_t l = 0; l < plan.lights.size(); ++l) {
        if (!plan.lights[l].shoots) continue;
        for (std::size_t t = 0; t < plan.targets.size(); ++t) {
            const plan::PhotonTarget& target = plan.targets[t];
            if (target.global_lights && (agree(plan.lights[l].refraction, target.refraction) ||
                                         agree(plan.lights[l].reflection, target.reflection)))
                units.push_back({l, t});
        }
    }
    return units;
}

/// The spacing that the settings ask for, or the one that makes about so many photons (spec 6, 3.3).
double spacing_of(const plan::CompiledScene& scene, const std::vector<PhotonUnit>& units)
{
    const plan::PhotonPlan& plan = *scene.photons;
    const double spacing = plan.settings.spacing;
    if (!(plan.settings.count > 0.0)) return spacing;
    double sum = 0.0;
    for (const PhotonUnit& unit : units) {
        const plan::PhotonTarget& target = plan.targets[unit.target];
        const plan::PhotonLight& light = plan.lights[unit.light];
        const bool refracts = agree(light.refraction, target.refraction),
                   reflects = agree(light.reflection, target.reflection);
        const double across = target.radius / (target.density * spacing);
        double x = std::numbers::pi * across * across;
        if (refracts && reflects) x *= 1.5;
        if (target.collect && refracts) x *= reflects ? 3.0 : 2.0;
        sum += 0.5 * x;
    }
    return spacing * std::sqrt(sum / plan.settings.count);
}

/// Shoots unit after unit; the photons of some rings at a time go to all threads.
class PhotonShooter {
public:
    PhotonShooter(const plan::CompiledScene& scene, const RenderOptions& options)
        : scene_(scene), options_(options), kernel_(load_kernel(options.isa)),
          workers_(
              options, [this] { return kernel_.make_photons(scene_, options_.cancel); }, kernel_.free_photons)
    {}

    std::vector<Photon> surface, media;

    /// False: cancelled.
    bool shoot()
    {
        const std::vector<PhotonUnit> units = units_of(scene_);
        const double spacing = spacing_of(scene_, units);
        std::vector<PhotonAim> aims;
        for (const PhotonUnit& unit : units) {
            aims.emplace_back(scene_.lights.lights[unit.light], plan_.lights[unit.light], plan_.targets[unit.target],
                              spacing, plan_.settings);
            if (aims.back().has_way()) expected_ += aims.back().estimate();
        }
        constexpr double kMostShot = 1e9;  // half an hour of one processor, and more than memory holds
        if (!(expected_ <= kMostShot))
            throw scene::Error(plan_.place, fmt::format("these photons would be {:.3g}, and at most {:.0g} are shot; a "
                                                        "wider spacing or a count makes them fewer",
                                                        expected_, kMostShot));
        for (std::size_t i = 0; i < units.size(); ++i)
            if (aims[i].has_way() && !shoot(units[i], aims[i])) return false;
        return true;
    }

private:
    bool shoot(const PhotonUnit& unit, PhotonAim& aim)
    {
        PhotonFlight flight;
        flight.light = &scene_.lights.lights[unit.light];
        flight.reflection = plan_.lights[unit.light].reflection;
        flight.refraction = plan_.lights[unit.light].refraction;
        flight.target = static_cast<std::uint32_t>(unit.target);
        flight.parallel = aim.parallel();
        flight.step = aim.step();
        std::vector<std::uint32_t> objects;
        scene_.world().containing(flight.light->location, objects);
        for (const std::uint32_t object : objects)
            if (scene_.objects[object].interior != plan::kNone)
                flight.interiors.push_back(scene_.objects[object].interior);
        hit_ = false;
        for (;;) {
            rings_.clear();
            emissions_.clear();
            constexpr std::size_t kBatch = std::size_t{64} * kTask;
            bool more = true;
            while (emissions_.size() < kBatch && (more = aim.ring(jitter_, emissions_)))
                rings_.push_back({emissions_.size(), aim.reach(), jitter_});
            if (!follow(flight)) return false;
            shot_ += static_cast<double>(emissions_.size());
            if (options_.progress) options_.progress(std::min(1.0, shot_ / expected_));
            if (!take() || !more) return true;
        }
    }

    /// All photons at hand, some a thread at a time.
    bool follow(const PhotonFlight& flight)
    {
        const std::size_t tasks = (emissions_.size() + kTask - 1) / kTask;
        if (yields_.size() < tasks) yields_.resize(tasks);
        starts_.assign(tasks, media_jitter_);
        if (leaves_in_media_) {
            // How many random numbers come before those of each photon is known when all of them have been counted.
            if (!run(flight, tasks, true)) return false;
            std::uint64_t sum = 0;
            for (std::size_t i = 0; i < tasks; ++i) {
                starts_[i].skip(sum);
                sum += yields_[i].draws_end.back();
            }
        }
        return run(flight, tasks, false);
    }

    bool run(const PhotonFlight& flight, std::size_t tasks, bool counting)
    {
        return workers_.each(0, tasks, [&](std::size_t i, auto& worker) {
            const std::size_t first = i * kTask, count = std::min(kTask, emissions_.size() - first);
            return kernel_.follow_photons(*worker.tracer, flight, std::span(emissions_).subspan(first, count),
                                          counting ? nullptr : &starts_[i], yields_[i]);
        });
    }

    /// The stream of photons in media goes on behind the last photon that counts.
    void move_media_jitter(std::size_t photons)
    {
        if (!leaves_in_media_ || photons == 0) return;
        const std::size_t task = (photons - 1) / kTask;
        JitterStream after = starts_[task];
        after.skip(yields_[task].draws_end[(photons - 1) % kTask]);
        media_jitter_ = after;
    }

    /// What the rings have left, up to the one where shooting stops. False: it stops.
    bool take()
    {
        std::size_t first = 0;
        for (const Ring& ring : rings_) {
            bool hit = false;
            for (std::size_t i = first; i < ring.end; ++i) {
                const PhotonYield& yield = yields_[i / kTask];
                const std::size_t k = i % kTask;
                hit |= yield.hit[k] != 0;
                append(yield.surface, yield.surface_end, k, surface);
                append(yield.media, yield.media_end, k, media);
            }
            check_room();
            first = ring.end;
            if (hit_ && !hit && ring.reach > plan_.settings.autostop) {
                jitter_ = ring.jitter;
                move_media_jitter(ring.end);
                return false;
            }
            hit_ |= hit;
        }
        move_media_jitter(emissions_.size());
        return true;
    }

    static void append(const std::vector<Photon>& from, const std::vector<std::uint32_t>& ends, std::size_t k,
                       std::vector<Photon>& to)
    {
        const std::size_t begin = k == 0 ? 0 : ends[k - 1];
        to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(begin),
                  from.begin() + static_cast<std::ptrdiff_t>(ends[k]));
    }

    void check_room() const
    {
        constexpr std::size_t kMostKept = 200'000'000;  // 4 GB
        if (surface.size() + media.size() > kMostKept)
            throw scene::Error(
                plan_.place,
                fmt::format("more than {} photons stay in the scene; a wider spacing makes them fewer", kMostKept));
    }

    struct Ring {
        std::size_t end;  ///< of its photons
        double reach;
        JitterStream jitter;  ///< when it was made
    };
    static constexpr std::size_t kTask = PhotonTracer::kMost;  ///< photons that a thread takes at a time

    const plan::CompiledScene& scene_;
    const plan::PhotonPlan& plan_ = *scene_.photons;
    const RenderOptions& options_;
    const KernelTable& kernel_;
    Workers<PhotonTracer> workers_;
    JitterStream jitter_, media_jitter_;
    const bool leaves_in_media_ = plan_.settings.media_steps > 0 && !scene_.media.media.empty();
    std::vector<JitterStream> starts_;  ///< by task, of its first photon in media
    std::vector<Emission> emissions_;
    std::vector<Ring> rings_;
    std::vector<PhotonYield> yields_;
    double expected_ = 0, shot_ = 0;  ///< photons, where no target is missed
    bool hit_ = false;                ///< some ring of the unit has met the target
};

}  // namespace

bool find_photons(const plan::CompiledScene& scene, const RenderOptions& options, IndirectLight& out)
{
    const scene::PhotonSettings& settings = scene.photons->settings;
    if (options.pass) options.pass("photons");
    if (options.prepared != nullptr) {
        out.photons.take(options.prepared->photons.surface);
        out.media_photons.take(options.prepared->photons.media);
    } else if (!settings.load_file.empty()) {
        PhotonFile file;
        try {
            file = read_photon_file(settings.load_file);
        } catch (const std::runtime_error& error) {
            throw scene::Error(scene.photons->place, error.what());
        }
        out.photons.take(std::move(file.surface));
        out.media_photons.take(std::move(file.media));
    } else {
        PhotonShooter shooter(scene, options);
        if (!shooter.shoot()) return false;
        out.photons.build(std::move(shooter.surface));
        out.media_photons.build(std::move(shooter.media));
    }
    if (!settings.save_file.empty() && options.prepared == nullptr) {
        try {
            write_photon_file(settings.save_file, out.photons.photons(), out.media_photons.photons());
        } catch (const std::runtime_error& error) {
            out.failed_save.emplace(scene.photons->place, error.what());
        }
    }
    LibraryRandom random;
    out.photons.find_radius(settings, false, random);
    out.media_photons.find_radius(settings, true, random);
    return true;
}

}  // namespace trace
