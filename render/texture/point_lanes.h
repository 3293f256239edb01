#pragma once

#include "csg/lanes.h"

#include <cstddef>

namespace texture {

/// Points that go through the vector unit together. Compiled once per instruction set.
using csg::lanes::Double;
inline constexpr std::size_t kLanes = static_cast<std::size_t>(csg::lanes::kDoubles);

}  // namespace texture
