#pragma once

#include <pybind11/pybind11.h>

namespace python {

/// Puts what solids are asked into the module: measure, mesh, section, spans.
void add_solid_answers(pybind11::module_& m);

}  // namespace python
