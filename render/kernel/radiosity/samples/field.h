#pragma once

#include "render/plan/compiled_scene.h"
#include "render/kernel/radiosity/samples/direction_order.h"
#include "render/kernel/radiosity/samples/pass_tile.h"
#include "render/kernel/radiosity/samples/rules.h"
#include "render/kernel/radiosity/samples/sample_grid.h"

#include <array>
#include <memory>
#include <vector>

namespace trace::radiosity {

/// All samples of a picture with what is needed to use them and to make more. Read by all threads; what they find is
/// added between them (passes.h).
struct Field {
    std::shared_ptr<const plan::Radiosity> plan;
    glm::dvec3 eye{0};                   ///< the camera's place, from which reaches are measured
    std::vector<BounceRules> rules;      ///< by bounce, as many as recursion_limit says
    std::vector<SampleGrid> samples;     ///< by bounce
    std::vector<glm::dvec3> directions;  ///< about +y
    DirectionOrder order;                ///< of these
    std::vector<std::uint8_t> black;     ///< by csg::SurfaceId: to rays of the last bounce; empty: not known

    explicit Field(const plan::CompiledScene& scene);
    const scene::RadiositySettings& settings() const { return plan->settings; }
    void add(const Found& found) { add(found, samples); }
    /// The same to others' samples by bounce.
    void add(const Found& found, std::vector<SampleGrid>& to) const
    {
        const auto bounce = static_cast<std::size_t>(found.bounce);
        to[bounce].add(found.sample, rules[bounce].ball * static_cast<double>(found.sample.reach));
    }
};

/// What one thread has found in a tile of a pass: its rays see it at once, other tiles when all of the same part of
/// the pass are through.
struct Filling {
    bool pretrace = true;                   ///< false: by the rules of the picture itself
    bool in_order = false;                  ///< samples are made in the order of the rays
    std::vector<SampleGrid> samples;        ///< by bounce
    std::vector<Found> found;               ///< the same in order
    std::vector<std::size_t> next;          ///< by bounce: the next direction
    std::array<float, 64> weight{};         ///< by camera ray: quarters of weight that its lookups found, added up
    std::array<std::uint16_t, 64> asked{};  ///< by camera ray: lookups

    void begin(const Field& field, const PassTile& tile);
};

}  // namespace trace::radiosity
