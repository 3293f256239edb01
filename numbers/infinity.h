#pragma once

#include <limits>

namespace csg {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace csg
