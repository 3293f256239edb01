#pragma once

#include "render/solid/measure/measure.h"
#include "render/solid/section/cutting_plane.h"

#include <atomic>

namespace solid {

/// Loops and the body in their plane, held against each other: distances in scene units, as sampled.
struct SectionCheck {
    double from_loops = 0.0;  ///< greatest, of places of the loops from the body's boundary in the plane
    double from_body = 0.0;   ///< greatest, of places where lines in the plane meet the boundary from the loops
    Bounded area;             ///< by the parts inside of lines in the plane
    std::size_t samples = 0;
};

/// \param wanted what is nearer is near enough to look no further
/// Throws csg::Cancelled.
SectionCheck check_section(const Body& body, const csg::Aabb& extent, const CuttingPlane& plane,
                           const std::vector<Loop>& loops, double wanted, const std::atomic<bool>* cancel);

}  // namespace solid
