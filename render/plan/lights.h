#pragma once

#include "render/light/light_set.h"
#include "render/plan/quality.h"
#include "render/scene/description.h"

namespace plan {

/// One light in world space. `to_world` includes the transformation of the object that holds the light.
/// quality: without area lights they are points.
light::Light compile_light(const scene::Light& description, const csg::Transform& to_world, const Quality& quality);

}  // namespace plan
