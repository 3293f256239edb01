#pragma once

#include "numbers/infinity.h"

/// All of csg is written in the words of the numbers floor: numbers, lanes of them, their roots.
namespace numbers::lanes {}
namespace numbers::detail {}

namespace csg {

using namespace numbers;

namespace lanes {
using namespace numbers::lanes;
}
namespace detail {
using namespace numbers::detail;
}

}  // namespace csg
