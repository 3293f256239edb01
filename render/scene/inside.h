#pragma once

#include "render/scene/object.h"

namespace scene {

/// Whether it is drawn but has no inside (spec 5b, 1.1).
bool is_patch(const Object& object);

/// Whether inside() can be asked of it: of a Csg every operand must have an inside, also where that means nothing.
bool has_inside(const Object& object);

/// Whether an operand of this CSG has forgets_inverse.
bool some_forget_inverse(const Object& object);
/// Before an object is transformed: those within that forget it are as if nothing had inverted them so far, by an
/// object that holds them or a difference that subtracts them.
void forget_inverse(Object& object);

}  // namespace scene
