#pragma once

#include <glm/glm.hpp>

#include <span>

namespace solid {

/// A place of a surface and its unit normal.
struct SurfacePoint {
    glm::dvec3 point{0.0}, normal{0.0};
};

/// The point nearest in the sense of least squares to the tangent planes of all; where they leave it free (one plane,
/// or two that meet in an edge) the nearest to `start`. Directions in which normals differ by less than
/// `kFree` of the strongest are free.
glm::dvec3 meeting_point(std::span<const SurfacePoint> tangents, const glm::dvec3& start);

}  // namespace solid
