#pragma once

#include "render/solid/measure/body.h"
#include "render/solid/mesh/qef.h"
#include "render/solid/mesh/tetrahedra.h"

#include <limits>

/// Where the boundary of a body passes through edges of tetrahedra.
namespace solid {

/// What is exact enough, in scene units.
struct Finish {
    double off = 0.0;    ///< the mesh may be so far from the body
    double least = 0.0;  ///< edges are not split below
    double grain = 0.0;  ///< vertices nearer to each other may become one in single precision
    double narrow =
        0.0;  ///< parts of an edge on the other side of the boundary are looked into if longer and twice as high
    /// Of the room that crossings leave in a face or tetrahedron: points inside keep so far from its border, and are
    /// moved there. Single precision asks for much.
    double inner = 0.25;
};

/// How far the surface goes away from a line between two passages (ends of chords of it from `from` along a unit
/// vector), as if it were two planes. What a line passes at a grazing angle again and again, as it does hills that lie
/// along it, stays near however long the parts between are.
double height_between(const Body& body, const glm::dvec3& from, const glm::dvec3& along, const End& a, const End& b);

/// An edge that the boundary passes through.
struct EdgeCut {
    std::uint64_t edge = 0;
    SurfacePoint place;    ///< where one end is inside and the other outside
    bool crosses = false;  ///< they are
    /// Where to split the edge, as a share of it from its first end, because the boundary passes more than once; NaN:
    /// nowhere.
    double split = std::numeric_limits<double>::quiet_NaN();
};

/// How near to the end of an edge of this length the surface may pass: nearer and triangles had no area.
double end_room(double length, const Finish& finish);

/// The boundary between the ends of an edge. `chords` of the line through it, as parameters from `from` in the
/// direction `along` of unit length; the edge lies in [start, start + length]. False: it does not pass there.
/// \param lost counts edges whose ends are on two sides though no chord ends between them
bool cut_edge(const Body& body, const Finish& finish, const glm::dvec3& from, const glm::dvec3& along, double start,
              double length, bool first_inside, bool second_inside, const std::vector<Chord>& chords, EdgeCut& out,
              std::uint64_t& lost);

/// The same of an edge by itself, whose line is followed.
bool cut_edge(const Body& body, const Finish& finish, const std::vector<glm::dvec3>& points,
              const std::vector<std::uint8_t>& inside, std::uint64_t edge, EdgeCut& out, std::uint64_t& lost);

}  // namespace solid
