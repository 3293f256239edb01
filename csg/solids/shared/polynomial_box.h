#pragma once

#include "csg/base/types.h"

#include <vector>

namespace csg {

/// Box of the points where a polynomial is not positive, if its terms of the highest degree are positive to all sides:
/// tori, blobs, ovals. Everything where they are not, or where that is not sure. Coefficients as of PolynomialShape.
/// Never too small.
Aabb polynomial_box(int degree, const std::vector<double>& coefficients);

}  // namespace csg
