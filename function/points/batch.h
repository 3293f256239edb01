#pragma once

#include "function/points/evaluate.h"
#include "numbers/instructions.h"

#include <xsimd/xsimd.hpp>

namespace function {

/// Numbers of a vector register of the processor that this copy is compiled for.
using Batch = xsimd::batch<double>;
inline constexpr std::size_t kWidth = Batch::size;
static_assert(kLanes % kWidth == 0);

}  // namespace function
