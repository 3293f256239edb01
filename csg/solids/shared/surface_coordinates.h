#pragma once

#include "csg/base/types.h"

namespace csg {

/// Of the unit vector from a sphere's centre: u about the y axis, v from pole to pole (spec 5a, 6).
glm::dvec2 sphere_uv(const glm::dvec3& n);

}  // namespace csg
