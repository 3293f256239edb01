#pragma once

#include "render/scene/base/message.h"

#include <pybind11/pybind11.h>

#include <vector>

namespace python {

/// Messages as whittle.Message has them: severity, text, file, line, column, whole text.
pybind11::list told(const std::vector<scene::Message>& messages);

/// Turns exceptions of ours into Python's: SceneError, ValueError, OSError, KeyboardInterrupt.
void register_errors();

}  // namespace python
