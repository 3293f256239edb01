#pragma once

#include "render/light/light_set.h"
#include "render/scene/description.h"

namespace plan {

/// One light in world space. `to_world` includes the transformation of the object that holds the light.
/// quality: below 5 an area light is a point.
light::Light compile_light(const scene::Light& description, const csg::Transform& to_world, int quality);

}  // namespace plan
