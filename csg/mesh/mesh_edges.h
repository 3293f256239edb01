#pragma once

#include "csg/mesh/mesh_shape.h"

namespace csg {

/// The edges that an odd number of faces share, as pairs of vertices; corners at the same place are one corner. A mesh
/// without any is closed: every ray crosses it an even number of times.
std::vector<std::array<std::uint32_t, 2>> open_edges(const MeshInput& input);

}  // namespace csg
