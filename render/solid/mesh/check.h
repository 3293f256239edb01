#pragma once

#include "render/solid/mesh/triangle_mesh.h"

#include <string>

namespace solid {

/// Whether triangles bound a body, as counted.
struct MeshCheck {
    std::size_t open_edges = 0;        ///< without a triangle on the other side, or with one that runs the same way
    std::size_t crowded_edges = 0;     ///< with more than two triangles
    std::size_t crowded_vertices = 0;  ///< whose triangles do not form one ring
    std::size_t twin_vertices = 0;     ///< in the place of another
    std::size_t collapsed = 0;         ///< triangles that name a vertex twice
    std::size_t parts = 0;             ///< that no triangles connect
    double volume = 0.0, surface = 0.0;
    double least_height = 0.0;  ///< of all triangles

    bool good() const
    {
        return open_edges + crowded_edges + crowded_vertices + twin_vertices + collapsed == 0 && parts > 0;
    }
    /// What is wrong, in words; empty where nothing is.
    std::string complaint() const;
};

/// Counts what a mesh has wrong; its volume is positive where triangles face outward.
MeshCheck check(const TriangleMesh& mesh);

}  // namespace solid
