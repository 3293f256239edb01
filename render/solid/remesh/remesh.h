#pragma once

#include "render/solid/mesh/mesher.h"

#include <functional>

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

/// A mesh of tetrahedra, remeshed: `extent` as met by rays. Where that does not go well, or does not serve, what
/// mesh_of() has, with normals. Throws csg::Cancelled, NoBody.
/// \param serves  asked last about what is returned
TriangleMesh good_mesh_of(const Body& body, const csg::Aabb& extent, const RefineOptions& options, MeshFacts& facts,
                          const std::function<bool(const TriangleMesh&)>& serves);

}  // namespace solid
