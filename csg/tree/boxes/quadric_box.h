#pragma once

#include "csg/solids/plane.h"
#include "csg/solids/quadric.h"

#include <vector>

namespace csg {

/// Box of what a quadric, half-spaces and `box` have in common: half-spaces across the axes of the quadric's own frame
/// bound its other axes (a cone between two planes). `box` itself where that says nothing; never too small.
Aabb quadric_box(const Quadric& quadric, const std::vector<Plane>& planes, const Aabb& box);

}  // namespace csg
