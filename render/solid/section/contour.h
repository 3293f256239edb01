#pragma once

#include "render/solid/measure/body.h"
#include "render/solid/section/cutting_plane.h"

#include <atomic>
#include <chrono>

namespace solid {

struct ContourOptions {
    double tolerance = 0.01;  ///< scene units between the body's boundary and the loops
    int cells = 128;          ///< of the first lattice, along the longest side
    std::size_t most_triangles = 6'000'000;
    /// Nothing is refined after it: loops close all the same, but may be farther off.
    std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
    const std::atomic<bool>* cancel = nullptr;
};

struct ContourFacts {
    int rounds = 0;
    std::size_t triangles = 0;   ///< of the plane
    std::uint64_t lost = 0;      ///< edges whose ends are on two sides though no chord ends between them
    bool full = false;           ///< there was no room to refine where it was wanted
    bool late = false;           ///< there was no time to
    std::size_t unresolved = 0;  ///< places that would have been refined, but are small enough
};

/// The same plane, or one beside it where a face of the body lies in it: what is inside of a face is a matter of
/// rounding. It goes some millionths of the body's size towards its middle.
CuttingPlane beside_faces(const Body& body, const csg::Aabb& extent, CuttingPlane plane);

/// The boundary of a body where a plane cuts it, as loops that neither cross nor touch: made as the mesher makes
/// triangles, of triangles instead of tetrahedra (docs/parts.md). Throws csg::Cancelled.
std::vector<Loop> contour_of(const Body& body, const csg::Aabb& extent, const CuttingPlane& plane,
                             const ContourOptions& options, ContourFacts& facts);

/// Loops without the points that lie on a straight line between others, as far as `room` from it.
std::vector<Loop> without_straight_points(const std::vector<Loop>& loops, double room);

double area_of(const std::vector<Loop>& loops);
double length_of(const std::vector<Loop>& loops);

}  // namespace solid
