#pragma once

#include "render/plan/compiled_scene.h"
#include "render/scene/base/color.h"
#include "render/kernel/tile/ray_counts.h"

#include <atomic>
#include <memory>
#include <span>

namespace trace {
namespace path {
struct Sources;
}

/// Where a path begins: a place of the picture, as SamplePosition has it, and the pixel's sequence of random numbers.
struct PathSample {
    double x = 0, y = 0;
    std::uint32_t seed = 0, index = 0;  ///< of the pixel; of the sample in it
};

/// What a path has brought.
struct PathFound {
    scene::Color color;  ///< radiance; transmit as of any other camera ray
    /// Of the first surface that scatters light or has its own, for those who filter the picture: what it makes of
    /// even light and what it gives off (the sky: that alone), its normal (0: none) and how far the path had come.
    glm::vec3 albedo{0}, normal{0};
    float depth = 0;
};

/// What the ray of a sample meets first, without light.
struct FirstHit {
    bool found = false;
    double depth = 0;  ///< distance from the start of the ray
    glm::dvec3 point{0};
    glm::vec3 normal{0};  ///< as shading sees it, towards the viewer
    glm::vec2 uv{0};
    glm::vec3 albedo{0};        ///< share of even light that leaves it again, and what it gives off
    std::uint32_t surface = 0;  ///< index into CompiledScene::surfaces; its texture is that of the side seen:
    std::uint32_t texture = plan::kNone;
};

/// Follows paths for one thread: docs/path_tracing.md.
class PathTracer {
public:
    /// \param scene  without radiosity and photons (plan::Options::paths)
    /// \param sources  of the same, which outlive it
    PathTracer(const plan::CompiledScene& scene, const path::Sources& sources, const std::atomic<bool>* cancel);
    ~PathTracer();
    PathTracer(const PathTracer&) = delete;
    PathTracer& operator=(const PathTracer&) = delete;

    /// Neighbours in the list should be neighbours in the picture. False: `cancel` was set meanwhile, and the tracer
    /// can only be freed.
    bool trace(std::span<const PathSample> samples, PathFound* out);
    /// What the samples' rays meet first. False: cancelled, as above.
    bool find_first_hits(std::span<const PathSample> samples, FirstHit* out);
    RayCounts counts() const;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace trace
