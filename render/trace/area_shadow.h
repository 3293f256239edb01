#pragma once

#include "render/trace/shade_context.h"

namespace trace {

/// Colour of an area light at a hit after sampling its shadow (spec 3, 12.6). `lit`: of the light's centre.
glm::vec3 area_shadow(Context& context, const HitContext& hit, const light::Light& light,
                      const light::Illumination& lit);

}  // namespace trace
