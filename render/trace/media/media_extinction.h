#pragma once

#include "render/trace/shade/shade_context.h"

namespace trace {

struct MediaMix;

/// Share of light that the media let through between two distances along a shadow ray (spec 6, 2.7 and 2.8).
glm::vec3 media_share(const plan::CompiledScene& scene, const MediaMix& mix, const csg::Ray& ray, double from,
                      double to);

/// The same of the media of what the ray is inside of; all of it where the ray is inside of something solid.
glm::vec3 interior_media_share(const plan::CompiledScene& scene, const RayState& ray, double from, double to);

}  // namespace trace
