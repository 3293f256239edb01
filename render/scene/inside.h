#pragma once

#include "render/scene/object.h"

namespace scene {

/// Whether it is drawn but has no inside (spec 5b, 1.1).
bool is_patch(const Object& object);

/// Whether inside() can be asked of it: of a Csg every operand must have an inside, also where that means nothing.
bool has_inside(const Object& object);

/// Whether an operand of this CSG has forgets_inverse.
bool some_forget_inverse(const Object& object);
/// What a transformation does to those within that forget it: held by an inverted object or subtracted, they are what
/// they were before, until they are inverted again.
void forget_inverse(Object& object);

}  // namespace scene
