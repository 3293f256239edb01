#pragma once

#include "render/trace/shade_context.h"

namespace trace {

/// `color` from one place of a light, which `lit` leads to, after what shadows it. Of a light that is projected through an
/// object only what stands in front of that counts (spec 3, 12.9). in_fog: fog dims it, unless it is shadowless.
glm::vec3 point_shadow(Context& context, const HitContext& hit, const light::Light& light, light::Illumination lit,
                       const glm::vec3& color, bool in_fog);

/// Colour of an area light at a hit after sampling its shadow (spec 3, 12.6). `lit`: of the light's centre.
glm::vec3 area_shadow(Context& context, const HitContext& hit, const light::Light& light,
                      const light::Illumination& lit);

}  // namespace trace
