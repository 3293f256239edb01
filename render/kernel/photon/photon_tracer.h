#pragma once

#include "render/plan/compiled_scene.h"
#include "render/kernel/gather/random_tables.h"
#include "render/kernel/photon/emission.h"
#include "render/kernel/gather/photon.h"

#include <atomic>
#include <memory>
#include <span>
#include <vector>

/// Photons on their way through the scene (spec 6, 3.5).
namespace trace {

/// What all photons of one light for one target have in common.
struct PhotonFlight {
    const light::Light* light = nullptr;
    plan::Consent reflection = plan::Consent::Unset, refraction = plan::Consent::Unset;  ///< of the light
    std::uint32_t target = 0;
    bool parallel = false;
    double step = 0;                       ///< PhotonAim::step
    std::vector<std::uint32_t> interiors;  ///< that hold the light
};

/// What became of some photons: those that stay, in the order in which POV-Ray lets them, photon by photon.
struct PhotonYield {
    std::vector<Photon> surface, media;
    std::vector<std::uint32_t> surface_end, media_end;  ///< by emission: how many there are up to it
    std::vector<std::uint8_t> hit;                      ///< by emission: it met the target
    /// Numbers that photons draw on their way through media: by emission, how many there are up to it; by step of the
    /// photons, in the order in which they are traced, how many come before it.
    std::vector<std::uint64_t> draws_end, draws_before;
};

/// Follows photons for one thread.
class PhotonTracer {
public:
    PhotonTracer(const plan::CompiledScene& scene, const std::atomic<bool>* cancel);
    ~PhotonTracer();
    PhotonTracer(const PhotonTracer&) = delete;
    PhotonTracer& operator=(const PhotonTracer&) = delete;

    static constexpr std::size_t kMost = 64;  ///< photons at a time

    /// Follows up to kMost photons. Where some may stay in media they have been counted before: `jitter` is where the
    /// stream stands that the first of them draws from. False: `cancel` was set meanwhile.
    bool follow(const PhotonFlight& flight, std::span<const Emission> photons, const JitterStream& jitter,
                PhotonYield& out);

    /// Finds PhotonYield::draws_end and draws_before alone.
    bool count(const PhotonFlight& flight, std::span<const Emission> photons, PhotonYield& out);

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace trace
