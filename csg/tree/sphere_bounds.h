#pragma once

#include "csg/tree/program.h"

namespace csg {

/// A box around what an intersection of solids draws, no larger than `program.bounds`: two spheres leave a lens that is
/// much smaller than what their boxes share.
Aabb lens_bounds(const Program& program, const SolidStore& store);

}  // namespace csg
