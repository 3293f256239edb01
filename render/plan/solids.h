#pragma once

#include "csg/solid.h"
#include "render/scene/object.h"

namespace plan {

/// A described primitive in world space. Not for meshes, CSG and lights.
csg::Solid world_solid(const scene::Shape& shape, const csg::Transform& to_world);

}  // namespace plan
