#pragma once

#include "render/plan/rendering_stack.h"

#include <tbb/global_control.h>

namespace solid {

/// Gives TBB's workers the stacks that the nests of a scene need: call it before the first of them begins.
inline void deepen_workers()
{
    static const tbb::global_control stacks(tbb::global_control::thread_stack_size, plan::rendering_stack());
}

}  // namespace solid
