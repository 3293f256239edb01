#pragma once

#include "function/program.h"

namespace function {

/// Makes the code of a function from its nodes: drops what the result does not need, gives every value a register for
/// as long as it is used.
void lower(Function& function);

}  // namespace function
