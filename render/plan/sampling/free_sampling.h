#pragma once

#include "render/light/light_set.h"
#include "render/scene/description.h"

namespace plan {

/// An area light as its face and not as a grid of lamps on it: a sample in each of four parts, anywhere there. A grid
/// of n nodes spans n - 1 cells and jitter moves each by half of one, so that nodes on axes (n - 1) / n as long cover
/// the face evenly, and no more; 2 x 2 of them are enough. Where a light has but one node along an axis it stays there.
void free_light(light::Light& light);

/// A lens all of whose places are asked for each sample, each moved anywhere within its part.
void free_lens(scene::Camera& camera);

}  // namespace plan
