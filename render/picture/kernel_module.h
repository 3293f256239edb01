#pragma once

#include "render/kernel/kernel.h"
#include "render/picture/render.h"

namespace trace {

/// The kernel for an instruction set, loaded from beside the program on first use and kept for good.
/// Throws std::runtime_error if the processor cannot run it or the module is missing.
const KernelTable& load_kernel(Isa isa);

}  // namespace trace
