#pragma once

#include "render/kernel/context/context.h"
#include "render/kernel/tile/air.h"

namespace trace {

/// The rainbows that a ray of this length sees (spec 2, section 17).
Air rainbow_air(const Context& context, const csg::Ray& ray, double length);

}  // namespace trace
