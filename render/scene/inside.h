#pragma once

#include "render/scene/object.h"

namespace scene {

/// Whether it is drawn but has no inside (spec 5b, 1.1).
bool is_patch(const Object& object);

/// Whether inside() can be asked of it: of a Csg every operand must have an inside, also where that means nothing.
bool has_inside(const Object& object);

}  // namespace scene
