#pragma once

#include "render/solid/measure/body.h"
#include "render/solid/mesh/refinement.h"
#include "render/solid/mesh/triangle_mesh.h"

namespace solid {

struct MeshFacts : RefineFacts {
    std::size_t joined = 0;  ///< vertices that single precision put in one place
    bool remeshed = false;   ///< remesh() made it anew; else it is as the lattice cut it
    std::size_t specks = 0;  ///< parts that are smaller than the tolerance, left out
};

/// The boundary of a body as triangles that close, meet edge to edge and nowhere else (docs/parts.md): `extent` as met
/// by rays. Throws csg::Cancelled, NoBody.
TriangleMesh mesh_of(const Body& body, const csg::Aabb& extent, const RefineOptions& options, MeshFacts& facts);

}  // namespace solid
