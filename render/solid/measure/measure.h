#pragma once

#include "render/solid/measure/body.h"

#include <atomic>

namespace solid {

/// A number and how far it may be off.
struct Bounded {
    double value = 0.0, error = 0.0;
};

/// What is told of a body of density 1.
struct Measures {
    csg::Aabb extent;           ///< met by rays: the body reaches so far at least
    double extent_error = 0.0;  ///< and no farther than that beyond, as far as is known
    Bounded volume, surface;
    glm::dvec3 centre{0.0}, centre_error{0.0};
    glm::dmat3 inertia{0.0};     ///< about the centre: moments on the diagonal, minus the products beside it
    double inertia_error = 0.0;  ///< of the entry that is least sure
    std::uint64_t rays = 0;
    bool empty = true;  ///< no ray met anything
};

struct MeasureOptions {
    double precision = 2e-4;  ///< of volume and surface, relative: refined until the errors told are below
    std::uint64_t most_rays = 30'000'000;
    const std::atomic<bool>* cancel = nullptr;
};

/// Throws NoBody where there is no inside or no end, csg::Cancelled.
Measures measure(const Body& body, const MeasureOptions& options = {});

/// The same of a body whose extent is known, as require_extent() tells it.
Measures measure_within(const Body& body, const csg::Aabb& extent, double extent_error, const MeasureOptions& options);

/// The box that rays meet, on a grid of `cells` of them along the longest side, in directions of all axes: ends of
/// chords, and then nearer about the outermost of each side. `error`: what the last step brought.
csg::Aabb met_extent(const Body& body, int cells, double& error, std::uint64_t& rays);

/// The same, or an exception that says why there is none.
csg::Aabb require_extent(const Body& body, double& error, std::uint64_t& rays);

}  // namespace solid
