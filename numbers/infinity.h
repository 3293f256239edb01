#pragma once

#include <limits>

namespace numbers {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace numbers
