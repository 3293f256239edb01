#pragma once

#include "render/light/light_set.h"
#include "render/plan/surface.h"

namespace plan {

/// Whether light groups let the light shine on the surface (spec 3, 12.10).
inline bool shines_on(const light::Light& light, const plan::Surface& surface)
{
    return light.group == surface.light_group || (light.group == 0 && surface.global_lights);
}

}  // namespace plan
