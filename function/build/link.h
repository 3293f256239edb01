#pragma once

#include "function/program.h"

#include <functional>

namespace function {

/// The same function with the slots of its patterns and pigments filled in, its own and those of functions it calls:
/// slot_of(use) gives one. What asks for neither comes back as it is.
FunctionPtr link(const FunctionPtr& function, const std::function<std::uint32_t(const SceneUse&)>& slot_of);

}  // namespace function
