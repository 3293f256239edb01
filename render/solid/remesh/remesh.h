#pragma once

#include "render/solid/mesh/mesher.h"

namespace solid {

/// Triangles of a good shape on the same surface: vertices on it and on its sharp edges, with its normals, edges as
/// long as the surface's bend and `options.tolerance` allow, flat faces by few. Edges are split, collapsed and flipped
/// and vertices moved along the surface (Botsch and Kobbelt, A remeshing approach to multiresolution modeling, 2004)
/// toward lengths that follow the curvature (Dunyach, Vanderhaeghe, Barthe and Botsch, Adaptive remeshing for real-time
/// mesh deformation, 2013). The mesh keeps its topology. False, and `mesh` as it was, where it does not close or
/// triangles came to cross. Throws csg::Cancelled.
bool remesh(const Body& body, const csg::Aabb& extent, const RefineOptions& options, TriangleMesh& mesh);

/// Normals of the body's surface at the corners of a mesh of it that closes; none where it does not.
void add_normals(const Body& body, const csg::Aabb& extent, const RefineOptions& options, TriangleMesh& mesh);

/// A mesh of few tetrahedra, remeshed: `extent` as met by rays. False where that does not go well. Throws
/// csg::Cancelled, NoBody.
bool remeshed(const Body& body, const csg::Aabb& extent, const RefineOptions& options, TriangleMesh& mesh,
              MeshFacts& facts);

/// What mesh_of() has, with normals.
TriangleMesh plain_mesh_of(const Body& body, const csg::Aabb& extent, const RefineOptions& options, MeshFacts& facts);

}  // namespace solid
