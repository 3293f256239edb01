#pragma once

#include "render/solid/mesh/cuts.h"

#include <array>

/// The surface inside of one tetrahedron, from where it passes through the edges.
namespace solid {

/// Where the surface passes through a face of a tetrahedron.
struct FaceCut {
    bool bent = false;    ///< `place` stands between the two edges: the straight line between them is too far off
    bool coarse = false;  ///< and it is too far off still
    SurfacePoint place;
    bool sharp = false;
};

/// \param lone  the corner on its own side of the boundary
/// \param p, q  where the surface passes through the edges from `lone` to m and n
FaceCut cut_face(const Body& body, const Finish& finish, const glm::dvec3& lone, const glm::dvec3& m,
                 const glm::dvec3& n, bool lone_inside, const SurfacePoint& p, const SurfacePoint& q);

/// The surface of one tetrahedron as a polygon, in order about it, seen from outside the body counter-clockwise.
struct Polygon {
    struct Corner {
        SurfacePoint place;
        bool on_face = false;
        bool sharp = false;
        std::uint32_t id = 0;  ///< of the edge or the face
    };
    std::array<Corner, 8> corners;
    std::size_t count = 0;
    bool any_on_face = false;
};

/// How the polygon in which the boundary passes a tetrahedron becomes triangles.
struct CentreCut {
    bool needed = false;  ///< triangles go from the polygon's sides to `place`; else the polygon is cut as it is
    bool coarse = false;  ///< some of them are too far off
    int diagonal = 0;     ///< of a polygon of four sides: from this corner
    glm::dvec3 place{0.0};
};

CentreCut cut_centre(const Body& body, const Finish& finish, const std::array<glm::dvec3, 4>& corners,
                     const Polygon& polygon);

}  // namespace solid
