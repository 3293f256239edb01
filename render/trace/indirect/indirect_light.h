#pragma once

#include "render/trace/radiosity/field.h"

#include <memory>

namespace trace {

/// Light that the passes before the picture have found; read by all threads while the picture is traced.
struct IndirectLight {
    std::unique_ptr<radiosity::Field> radiosity;  ///< null: off
};

}  // namespace trace
