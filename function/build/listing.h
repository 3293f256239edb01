#pragma once

#include "function/program.h"

#include <string>
#include <vector>

namespace function {

/// The program as text, one line an instruction: `r4 = multiply r0 r1`. Constants stand as numbers, parameters as p0,
/// p1,
/// ...; what follows a select or a loop names the lines of its parts. The last line is the result.
std::vector<std::string> listing(const Function& function);

}  // namespace function
