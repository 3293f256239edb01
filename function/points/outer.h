#pragma once

#include "function/program.h"

namespace function {

/// A transformation, spline, pattern or pigment at a point (or a number, for a spline).
std::array<double, 5> outer_value(const SceneReference& what, const double* a, const Host& host);

}  // namespace function
