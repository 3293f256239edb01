#pragma once

#include "render/solid/measure/body.h"
#include "render/solid/mesh/refinement.h"
#include "render/solid/section/cutting_plane.h"

namespace solid {

inline constexpr int kContourCells = 128;  ///< of the first lattice of a drawing

/// The same plane, or one beside it where a face of the body lies in it: what is inside of a face is a matter of
/// rounding. It goes some millionths of the body's size towards its middle.
CuttingPlane beside_faces(const Body& body, const csg::Aabb& extent, CuttingPlane plane);

/// The boundary of a body where a plane cuts it, as loops that neither cross nor touch: made as the mesher makes
/// triangles, of triangles instead of tetrahedra (docs/parts.md). Throws csg::Cancelled.
std::vector<Loop> contour_of(const Body& body, const csg::Aabb& extent, const CuttingPlane& plane,
                             const RefineOptions& options, RefineFacts& facts);

/// Loops without the points that lie on a straight line between others, as far as `room` from it.
std::vector<Loop> without_straight_points(const std::vector<Loop>& loops, double room);

/// From a point to the straight line between two others.
double distance_to_side(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b);

/// The area within loops, holes running the other way round, and the length of all of them, scene units.
double area_of(const std::vector<Loop>& loops);
double length_of(const std::vector<Loop>& loops);

}  // namespace solid
