#pragma once

#include "csg/mesh/mesh_shape.h"

#include <span>

namespace csg {

/// The inside vector of a closed mesh that was given none: every direction says the same of it. Along no axis, nor in
/// the plane of two, for that is where faces and edges of parts lie.
inline const glm::dvec3 kAnyInsideVector{0.4142135624, 0.7320508076, 0.5408641};

/// How the faces of a mesh meet. Corners at the same place are one corner.
struct MeshEdges {
    /// Those that an odd number of faces share, as pairs of vertices. None: the mesh is closed, and every ray crosses
    /// it an even number of times.
    std::vector<std::array<std::uint32_t, 2>> open;
    /// Each edge is passed as often one way as the other: where the mesh is closed too, its faces bound a solid.
    bool oriented = true;
};
MeshEdges edges_of(std::span<const glm::dvec3> vertices, std::span<const std::array<std::uint32_t, 3>> faces);

/// MeshEdges::open of a mesh.
std::vector<std::array<std::uint32_t, 2>> open_edges(const MeshInput& input);

}  // namespace csg
