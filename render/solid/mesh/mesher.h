#pragma once

#include "render/solid/measure/body.h"
#include "render/solid/mesh/triangle_mesh.h"

#include <atomic>
#include <chrono>

namespace solid {

struct MeshOptions {
    double tolerance = 0.01;  ///< scene units between body and mesh
    int cells = 16;           ///< of the first lattice, along the longest side
    std::size_t most_tetrahedra = 6'000'000;
    /// Nothing is refined after it: the mesh closes all the same, but may be farther off.
    std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
    const std::atomic<bool>* cancel = nullptr;
};

struct MeshFacts {
    int rounds = 0;
    std::size_t tetrahedra = 0;
    std::uint64_t lost = 0;      ///< edges whose ends are on two sides though no chord ends between them
    std::size_t joined = 0;      ///< vertices that single precision put in one place
    std::size_t specks = 0;      ///< parts that are smaller than the tolerance, left out
    bool full = false;           ///< there was no room to refine where it was wanted
    bool late = false;           ///< there was no time to
    std::size_t unresolved = 0;  ///< places that would have been refined, but are small enough
};

/// The boundary of a body as triangles that close, meet edge to edge and nowhere else (docs/parts.md): `extent` as met
/// by rays. Throws csg::Cancelled, NoBody.
TriangleMesh mesh_of(const Body& body, const csg::Aabb& extent, const MeshOptions& options, MeshFacts& facts);

}  // namespace solid
