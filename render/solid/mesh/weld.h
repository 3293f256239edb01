#pragma once

#include "render/solid/mesh/triangle_mesh.h"

namespace solid {

/// Joins neighbouring vertices that single precision put in one place, where the mesh stays a closed surface: the
/// triangles that go have no area. Vertices that no triangle names are dropped. Returns how many were joined.
std::size_t weld(TriangleMesh& mesh);

/// Drops connected parts no wider than `size` to any side; returns how many.
std::size_t drop_specks(TriangleMesh& mesh, double size);

}  // namespace solid
