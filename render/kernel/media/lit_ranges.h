#pragma once

#include "csg/base/types.h"
#include "render/light/light_set.h"

namespace trace {

/// A stretch of a ray, by distances from its origin.
struct MediaRange {
    double from = 0, to = 0;
};

/// Where a light may reach a ray of that length: all of it, or what lies in its cone or cylinder (spec 6, 2.4). False:
/// nowhere.
bool lit_range(const light::Light& light, const csg::Ray& ray, double length, MediaRange& out);

}  // namespace trace
