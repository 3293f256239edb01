#pragma once

#include <pybind11/pybind11.h>

namespace python {

/// Puts `compare` into the module: the numbers of `whittle compare`, of files or arrays.
void add_comparison(pybind11::module_& m);

}  // namespace python
