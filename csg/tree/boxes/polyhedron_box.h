#pragma once

#include "csg/solids/plane.h"

#include <vector>

namespace csg {

/// Box of what the half-spaces and `box` have in common, by enumerating vertices; `box` itself where that is unbounded
/// or there are too many planes for it. Never too small.
Aabb polyhedron_box(const std::vector<Plane>& planes, const Aabb& box);

}  // namespace csg
