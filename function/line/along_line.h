#pragma once

#include "csg/freeform/field/field.h"
#include "function/program.h"

namespace function {

/// The function's first component along a stretch, which is given to x, y and z in turn. False, with `out` as it was,
/// where it is no polynomial there, or one of too high a degree.
bool evaluate_along(const Function& function, const csg::FieldStretch& stretch, csg::FieldPolynomial& out);

}  // namespace function
