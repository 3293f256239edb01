#pragma once

#include "render/solid/measure/body.h"
#include "render/solid/mesh/qef.h"

#include <span>

/// Places on a body's own surface, by lines through it.
namespace solid {

/// Where a line leaves the body.
struct Foot {
    bool found = false;
    SurfacePoint at;  ///< the normal is the solid's own, or the line's direction where it knows none
    End end;
};

/// The place nearest to `point` where the line along the unit vector `out` leaves the body, no farther than `reach`.
Foot foot_of(const Body& body, const glm::dvec3& point, const glm::dvec3& out, double reach);

/// One side of a sharp edge or corner, as far as it is known.
struct Side {
    glm::dvec3 within{0.0};  ///< a point well within the side, near the surface
    glm::dvec3 normal{0.0};  ///< of the surface there, about
    Foot foot;               ///< the last that was met
};

/// The place where all sides meet, near `start`: tangent planes meet there, taken ever nearer to it (Newton's method).
/// Where two meet, what is free along the edge stays. False: a side is not met, or the place runs off.
/// \param size how far off it may be
/// \param steps 1 to kExactSteps: of a side that is bent, the place is off by so much less with each
bool meeting_place(const Body& body, std::span<Side> sides, const glm::dvec3& start, double size, std::size_t steps,
                   glm::dvec3& out);
inline constexpr std::size_t kExactSteps = 5, kRoughSteps = 2;

/// Whether the surface is bent sharply between two places, however near to it one looks.
bool is_sharp_between(const Body& body, const SurfacePoint& a, const SurfacePoint& b);

inline constexpr double kSharpTurn = 0.956;  ///< cosine of 17 degrees: what bends less is not an edge

}  // namespace solid
