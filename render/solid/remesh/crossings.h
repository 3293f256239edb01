#pragma once

#include "render/solid/mesh/triangle_mesh.h"

namespace solid {

/// Pairs of triangles without a common vertex of which an edge of one runs through the inside of the other.
std::size_t crossings(const TriangleMesh& mesh);

}  // namespace solid
