#pragma once

#include "csg/hit.h"

namespace csg {

/// What one thread needs to answer rays; reused, never shared.
struct Scratch {};

}  // namespace csg
