#pragma once

#include "numbers/infinity.h"

/// Makes the names of numbers/ names of csg too, which uses them throughout.
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
